// The page of the sound's cost: threshold, slope, mode budget and compression, and their current
// effect.
#pragma once

#include "Editor/BudgetRamp.h"
#include "Editor/DeckPage.h"
#include "Editor/ParameterColumns.h"
#include "Editor/SoundMeters.h"

#include <array>
#include <memory>

namespace idiophone {

class QualityPage final : public DeckPage {
public:
    explicit QualityPage(ProcessorView& view);

    void refresh() override { columns.refresh(); }
    void showSound(const SoundFrame& frame) override;

    void resized() override;

private:
    /// Counts of sounding modes and of silent ones by reason.
    class Counts final : public juce::Component {
    public:
        Counts();

        void show(const SoundFrame& frame);

        void paint(juce::Graphics& g) override;
        std::unique_ptr<juce::AccessibilityHandler> createAccessibilityHandler() override;

    private:
        struct Count {
            const char* name;
            std::int32_t modes = 0;
        };

        std::array<Count, 4> counts{{{"sounding"}, {"dropped"}, {"merged"}, {"over budget"}}};
    };

    ParameterColumns columns;
    Counts counts;
    BudgetRamp ramp;
    SoundMeters meters;
};

} // namespace idiophone
