// The outline around the component that the Tab key focused.
#pragma once

#include "Editor/Look.h"

#include <utility>

namespace idiophone {

/// Covers its parent, the window, and ignores the mouse. It appears only for keyboard navigation:
/// after a click the user knows the place.
class FocusRing final : public juce::Component, private juce::FocusChangeListener {
public:
    FocusRing() {
        setInterceptsMouseClicks(false, false);
        setAccessible(false);
        juce::Desktop::getInstance().addFocusChangeListener(this);
    }
    ~FocusRing() override { juce::Desktop::getInstance().removeFocusChangeListener(this); }

    /// Call before a key moves the focus.
    void tabPressed() { isByKey = true; }

    /// The component with the outline, or nullptr.
    juce::Component* component() const { return focused; }

    /// Call after the window's components have moved.
    void follow() {
        setVisible(focused != nullptr);
        if (focused == nullptr)
            return;
        const auto* window = getParentComponent();
        setBounds(window->getLocalArea(focused, focused->getLocalBounds())
                      .expanded(2)
                      .getIntersection(window->getLocalBounds()));
        toFront(false);
        repaint();
    }

    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::text));
        g.drawRoundedRectangle(getLocalBounds().toFloat().reduced(0.75f), 5, 1.5f);
    }

private:
    void globalFocusChanged(juce::Component* now) override {
        const auto* window = getParentComponent();
        const bool isHere = now != nullptr && window != nullptr && window->isParentOf(now);
        focused = std::exchange(isByKey, false) && isHere &&
                          !juce::ModifierKeys::currentModifiers.isAnyMouseButtonDown()
                      ? now
                      : nullptr;
        follow();
    }

    juce::Component::SafePointer<juce::Component> focused;
    bool isByKey = false;
};

} // namespace idiophone
