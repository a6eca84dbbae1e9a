// A control that ignores the right mouse button, so that its parent can use it.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>
#include <utility>

namespace idiophone {

template <class Control>
class LeftClicked : public Control {
public:
    using Control::Control;

    void mouseDown(const juce::MouseEvent& event) override {
        isOwn = !event.mods.isPopupMenu();
        if (isOwn)
            Control::mouseDown(event);
    }
    void mouseDrag(const juce::MouseEvent& event) override {
        if (isOwn)
            Control::mouseDrag(event);
    }
    void mouseUp(const juce::MouseEvent& event) override {
        if (std::exchange(isOwn, false))
            Control::mouseUp(event);
    }

    /// Whether the left button is down on the control.
    bool isPressed() const { return isOwn; }

private:
    /// Set when the press begins. JUCE ends a press when the last button comes up, and that may be
    /// any button.
    bool isOwn = false;
};

} // namespace idiophone
