// How the budget of modes is shared among the objects that sound: a bar each, loudest first, for
// what it asks and what it has, and the line of slope S that says what it may have.
#pragma once

#include "Editor/SoundView.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <vector>

namespace idiophone {

/// Readable from 240 x 80 px on.
class BudgetRamp final : public juce::Component, public juce::SettableTooltipClient {
public:
    BudgetRamp();

    /// Repaints where that looks different.
    void show(const SoundFrame& frame);

    /// What is seen, in words.
    juce::String description() const;

    void paint(juce::Graphics& g) override;
    std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override;

private:
    /// All that is drawn of a slot, in modes.
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
