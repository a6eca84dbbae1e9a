// The outline around what the Tab key has chosen.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Lies over the window, its parent, and lets the mouse through. It shows only on the way by
/// keyboard: who clicks knows where.
class FocusRing final : public juce::Component, private juce::FocusChangeListener {
public:
    FocusRing();
    ~FocusRing() override;

    /// The focus is about to move by a key.
    void tabPressed() { isByKey = true; }

    /// The window's parts have moved.
    void follow();

    void paint(juce::Graphics& g) override;

private:
    void globalFocusChanged(juce::Component* now) override;

    juce::Component::SafePointer<juce::Component> focused;
    bool isByKey = false;
};

} // namespace idiophone
