// The outline around the window while the user drags a file over it that it can open.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Covers the window and ignores the mouse. OpenGL covers components over its picture, so the frame
/// uses only the window's margin and top.
class DropFrame final : public juce::Component {
public:
    DropFrame() {
        setInterceptsMouseClicks(false, false);
        setAccessible(false);
    }

    /// Shows the file's name, without its folder. An empty name hides the frame.
    void show(const juce::String& fileName);

    void paint(juce::Graphics& g) override;

private:
    juce::String name;
};

} // namespace idiophone
