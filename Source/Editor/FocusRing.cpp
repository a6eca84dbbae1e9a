#include "Editor/FocusRing.h"

#include "Editor/Look.h"

#include <utility>

namespace idiophone {
namespace {

constexpr int gap = 2;

} // namespace

FocusRing::FocusRing() {
    setInterceptsMouseClicks(false, false);
    setAccessible(false);
    juce::Desktop::getInstance().addFocusChangeListener(this);
}

FocusRing::~FocusRing() {
    juce::Desktop::getInstance().removeFocusChangeListener(this);
}

void FocusRing::globalFocusChanged(juce::Component* now) {
    const bool isHere =
        now != nullptr && getParentComponent() != nullptr && getParentComponent()->isParentOf(now);
    focused = std::exchange(isByKey, false) && isHere &&
                      !juce::ModifierKeys::currentModifiers.isAnyMouseButtonDown()
                  ? now
                  : nullptr;
    follow();
}

void FocusRing::follow() {
    setVisible(focused != nullptr);
    if (focused == nullptr)
        return;
    setBounds(getParentComponent()
                  ->getLocalArea(focused, focused->getLocalBounds())
                  .expanded(gap)
                  .getIntersection(getParentComponent()->getLocalBounds()));
    toFront(false);
    repaint();
}

void FocusRing::paint(juce::Graphics& g) {
    g.setColour(colourOf(*this, LookColour::text));
    g.drawRoundedRectangle(getLocalBounds().toFloat().reduced(0.75f), 5, 1.5f);
}

} // namespace idiophone
