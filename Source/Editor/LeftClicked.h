// A control that leaves the right button to the one it is part of.
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

private:
    /// By how it began: it ends with the last button that comes up, whichever that is.
    bool isOwn = false;
};

} // namespace idiophone
