// The outline around the window while a file hovers over it that would be opened there.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Lies over the window and lets the mouse through. OpenGL draws over what lies under its picture,
/// so that the frame keeps to the window's margin and top.
class DropFrame final : public juce::Component {
public:
    DropFrame() {
        setInterceptsMouseClicks(false, false);
        setAccessible(false);
    }

    /// The name of what hovers, without its folder; empty hides the frame.
    void show(const juce::String& fileName);

    void paint(juce::Graphics& g) override;

private:
    juce::String name;
};

} // namespace idiophone
