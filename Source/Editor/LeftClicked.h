// A control that leaves the right button to the one it is part of.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

template <class Control>
class LeftClicked : public Control {
public:
    using Control::Control;

    void mouseDown(const juce::MouseEvent& event) override {
        if (!event.mods.isPopupMenu())
            Control::mouseDown(event);
    }
    void mouseDrag(const juce::MouseEvent& event) override {
        if (!event.mods.isPopupMenu())
            Control::mouseDrag(event);
    }
    void mouseUp(const juce::MouseEvent& event) override {
        if (!event.mods.isPopupMenu())
            Control::mouseUp(event);
    }
};

} // namespace idiophone
