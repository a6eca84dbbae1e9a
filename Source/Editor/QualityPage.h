// The page of the sound's cost: threshold, slope, mode budget and compression, and their current
// effect.
#pragma once

#include "Editor/BudgetRamp.h"
#include "Editor/DeckPage.h"
#include "Editor/Look.h"
#include "Editor/ModeCounts.h"
#include "Editor/ParameterColumns.h"
#include "Editor/SoundMeters.h"

#include <vector>

namespace idiophone {

class QualityPage final : public DeckPage {
public:
    explicit QualityPage(ProcessorView& view)
        : DeckPage("Quality"),
          columns(std::vector<ParameterGroup>{{"Modes that sound", 0}, {"Budget", 1}}, view) {
        showParts(*this, columns, counts, ramp, meters);
    }

    void refresh() override { columns.refresh(); }
    void showSound(const SoundFrame& frame) override {
        counts.show(frame);
        ramp.show(frame);
        meters.show(frame);
    }

    void resized() override {
        auto area = getLocalBounds().reduced(padding);
        columns.setBounds(area.removeFromTop(getHeight() < 360 ? 86 : 112));
        counts.setBounds(area.removeFromTop(50));
        meters.setBounds(area.removeFromBottom(51));
        ramp.setBounds(area.withTrimmedBottom(2));
    }

private:
    ParameterColumns columns;
    ModeCounts counts;
    BudgetRamp ramp;
    SoundMeters meters;
};

} // namespace idiophone
