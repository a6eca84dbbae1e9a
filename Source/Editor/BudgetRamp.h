// A bar chart of how the mode budget is shared among the resonators, loudest first. Each bar
// shows requested and granted modes; a line of slope S shows the entitlement.
#pragma once

#include "Editor/SoundView.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

/// Needs at least 240 x 80 px.
class BudgetRamp final : public juce::Component, public juce::SettableTooltipClient {
public:
    BudgetRamp();

    /// Repaints only if the picture changes.
    void show(const SoundFrame& frame);

    /// Describes the chart for a screen reader and the caption.
    juce::String description() const;

    void paint(juce::Graphics& g) override;
    std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override;

private:
    /// The bar of one slot, in modes.
    struct Bar {
        std::int32_t asked = 0;
        std::int32_t share = 0;
        float entitlement = 0;

        bool operator==(const Bar&) const = default;
    };

    juce::Rectangle<float> plot() const;
    float highest() const;
    void paintAxis(juce::Graphics& g) const;

    std::vector<Bar> bars;
    double budgetModes = 0;
    std::int32_t modesMixed = 0;
};

} // namespace idiophone
