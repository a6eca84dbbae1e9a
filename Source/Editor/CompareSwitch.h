// The A/B switch: the playing sound is lit, a click plays the other.
#pragma once

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// The toggle state is on while B plays. Needs 52 x 24 pixels.
class CompareSwitch final : public juce::Button {
public:
    CompareSwitch();

    void paintButton(juce::Graphics& g, bool highlighted, bool down) override;
};

} // namespace idiophone
