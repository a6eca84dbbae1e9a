// Presses of the mouse, made without a screen.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone::test {

/// An event of a press that began at `from`; both places are in the component.
inline juce::MouseEvent mouseAt(juce::Component& part,
                                juce::Point<float> place,
                                juce::Point<float> from,
                                int buttons = juce::ModifierKeys::leftButtonModifier) {
    return {juce::Desktop::getInstance().getMainMouseSource(),
            place,
            buttons,
            0,
            0,
            0,
            0,
            0,
            &part,
            &part,
            juce::Time(2000),
            from,
            juce::Time(1000),
            1,
            place != from};
}

/// Presses at a place, moves by some steps to another, and releases.
inline void dragOver(juce::Component& part, juce::Point<float> from, juce::Point<float> to) {
    constexpr int steps = 5;
    part.mouseDown(mouseAt(part, from, from));
    for (int step = 1; step <= steps; ++step)
        part.mouseDrag(
            mouseAt(part, from + (to - from) * (static_cast<float>(step) / steps), from));
    part.mouseUp(mouseAt(part, to, from));
}

inline void clickOn(juce::Component& part, juce::Point<float> place) {
    part.mouseDown(mouseAt(part, place, place));
    part.mouseUp(mouseAt(part, place, place));
}

/// The four calls that JUCE makes.
inline void doubleClickOn(juce::Component& part, juce::Point<float> place) {
    clickOn(part, place);
    part.mouseDown(mouseAt(part, place, place));
    part.mouseDoubleClick(mouseAt(part, place, place));
    part.mouseUp(mouseAt(part, place, place));
}

} // namespace idiophone::test
