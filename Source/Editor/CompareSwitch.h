// The A/B switch: the playing sound is lit, a click plays the other.
#pragma once

#include "Editor/Look.h"

namespace idiophone {

/// The toggle state is on while B plays. Needs 52 x 24 pixels.
class CompareSwitch final : public juce::Button {
public:
    CompareSwitch() : Button("Compare") {
        setTitle("Compare A and B");
        setTooltip("Play the other sound of A and B. Editing changes the one that plays.");
    }

    void paintButton(juce::Graphics& g, bool highlighted, bool) override {
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
        g.setColour(colourOf(*this, isB ? LookColour::text : LookColour::onAccent));
        g.drawText("A", left, juce::Justification::centred, false);
        g.setColour(colourOf(*this, isB ? LookColour::onAccent : LookColour::text));
        g.drawText("B", right, juce::Justification::centred, false);
        if (hasKeyboardFocus(false)) {
            g.setColour(colourOf(*this, LookColour::accent));
            g.drawRoundedRectangle(area, 5, 1.5f);
        }
    }
};

} // namespace idiophone
