// The page of the deck that says what the sound costs and what is left out of it: threshold, slope,
// budget and compression, and what they do right now.
#pragma once

#include "Editor/BudgetRamp.h"
#include "Editor/DeckPage.h"
#include "Editor/ParameterColumns.h"
#include "Editor/SoundMeters.h"

#include <array>

namespace idiophone {

class QualityPage final : public DeckPage {
public:
    explicit QualityPage(ProcessorView& view);

    void refresh() override { columns.refresh(); }
    void showSound(const SoundFrame& frame) override;

    void paint(juce::Graphics& g) override;
    void resized() override;

private:
    struct Count {
        const char* name;
        std::int32_t modes = 0;
    };

    ParameterColumns columns;
    std::array<Count, 4> counts{{{"sounding"}, {"dropped"}, {"merged"}, {"over budget"}}};
    juce::Rectangle<int> countArea;
    BudgetRamp ramp;
    SoundMeters meters;
};

} // namespace idiophone
