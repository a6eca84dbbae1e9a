// A slider of a parameter with keys: arrows and page keys move it by fractions of its length, and
// Shift makes arrow steps smaller. Return opens the text field. A double click resets it.
#pragma once

#include "Editor/LeftClicked.h"
#include "Parameters/ParameterTable.h"

#include <algorithm>
#include <functional>

namespace idiophone {

class KeyedSlider final : public LeftClicked<juce::Slider> {
public:
    explicit KeyedSlider(const ParameterInfo& row)
        : LeftClicked(juce::Slider::LinearHorizontal, juce::Slider::NoTextBox), info(row) {
        setWantsKeyboardFocus(true);
        // After a click the computer's keys keep playing notes.
        setMouseClickGrabsKeyboardFocus(false);
        setNormalisableRange(
            {info.minimum, info.maximum,
             [&row](double, double, double place) { return row.fromNormalised(place); },
             [&row](double, double, double value) { return row.toNormalised(value); },
             [&row](double, double, double value) { return row.clamped(value); }});
    }

    std::function<void()> onReturn;

    /// Sets what a double click and an Alt-click give. The arc of a knob starts there.
    void setResetValue(double value) {
        if (isDoubleClickReturnEnabled() && value == getDoubleClickReturnValue())
            return;
        setDoubleClickReturnValue(true, value);
        repaint();
    }

    void mouseDown(const juce::MouseEvent& event) override {
        isMoved = false;
        LeftClicked::mouseDown(event);
    }
    void mouseUp(const juce::MouseEvent& event) override {
        isMoved = event.mouseWasDraggedSinceMouseDown();
        LeftClicked::mouseUp(event);
    }
    /// Whether the mouse moved during the press that ended last.
    bool wasMoved() const { return isMoved; }

    bool keyPressed(const juce::KeyPress& key) override {
        using juce::KeyPress;
        const double arrow = key.getModifiers().isShiftDown() ? 0.001 : 0.01, page = 0.1;
        if (key.isKeyCode(KeyPress::returnKey))
            onReturn();
        else if (key.isKeyCode(KeyPress::homeKey))
            moveBy(-1);
        else if (key.isKeyCode(KeyPress::endKey))
            moveBy(1);
        else if (key.isKeyCode(KeyPress::rightKey) || key.isKeyCode(KeyPress::upKey))
            moveBy(stepOf(arrow));
        else if (key.isKeyCode(KeyPress::leftKey) || key.isKeyCode(KeyPress::downKey))
            moveBy(-stepOf(arrow));
        else if (key.isKeyCode(KeyPress::pageUpKey))
            moveBy(stepOf(page));
        else if (key.isKeyCode(KeyPress::pageDownKey))
            moveBy(-stepOf(page));
        else
            return false;
        return true;
    }

private:
    /// Whole numbers move by at least 1.
    double stepOf(double fraction) const {
        return info.scale == ParameterScale::steps
                   ? std::max(fraction, 1 / (info.maximum - info.minimum))
                   : fraction;
    }

    void moveBy(double fraction) {
        const double place = valueToProportionOfLength(getValue()) + fraction;
        setValue(proportionOfLengthToValue(std::clamp(place, 0.0, 1.0)),
                 juce::sendNotificationSync);
    }

    bool isMoved = false;
    const ParameterInfo& info; ///< a row of the table, which is never destroyed
};

} // namespace idiophone
