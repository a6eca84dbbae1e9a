// The outline around the component that the Tab key focused.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Covers its parent, the window, and ignores the mouse. It appears only for keyboard navigation:
/// after a click the user knows the place.
class FocusRing final : public juce::Component, private juce::FocusChangeListener {
public:
    FocusRing();
    ~FocusRing() override;

    /// Call before a key moves the focus.
    void tabPressed() { isByKey = true; }

    /// Call after the window's components have moved.
    void follow();

    void paint(juce::Graphics& g) override;

private:
    void globalFocusChanged(juce::Component* now) override;

    juce::Component::SafePointer<juce::Component> focused;
    bool isByKey = false;
};

} // namespace idiophone
