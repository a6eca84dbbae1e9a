#include "Editor/CompareSwitch.h"

#include "Editor/Look.h"

namespace idiophone {

CompareSwitch::CompareSwitch() : Button("Compare") {
    setTitle("Compare A and B");
    setTooltip("Play the other sound of A and B. Editing changes the one that plays.");
}

void CompareSwitch::paintButton(juce::Graphics& g, bool highlighted, bool) {
    const auto area = getLocalBounds().toFloat().reduced(1);
    const bool isB = getToggleState();
    g.setColour(colourOf(*this, LookColour::outline));
    g.fillRoundedRectangle(area, 5);
    if (!highlighted) {
        g.setColour(colourOf(*this, LookColour::background));
        g.fillRoundedRectangle(area.reduced(1.5f), 4);
    }
    auto left = area.reduced(3);
    auto right = left.removeFromRight(left.getWidth() / 2);
    g.setColour(colourOf(*this, LookColour::accent));
    g.fillRoundedRectangle(isB ? right : left, 3);
    g.setFont(Look::headingFont(13));
    const auto letter = [&](const char* name, juce::Rectangle<float> place, bool plays) {
        g.setColour(colourOf(*this, plays ? LookColour::onAccent : LookColour::text));
        g.drawText(name, place, juce::Justification::centred, false);
    };
    letter("A", left, !isB);
    letter("B", right, isB);
    if (hasKeyboardFocus(false)) {
        g.setColour(colourOf(*this, LookColour::accent));
        g.drawRoundedRectangle(area, 5, 1.5f);
    }
}

} // namespace idiophone
