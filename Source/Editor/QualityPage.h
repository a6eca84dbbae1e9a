// The page of the sound's cost: a choice of qualities, the threshold, slope, mode budget and
// compression that it sets, and their current effect.
#pragma once

#include "Editor/BudgetRamp.h"
#include "Editor/DeckPage.h"
#include "Editor/Look.h"
#include "Editor/ModeCounts.h"
#include "Editor/ParameterColumns.h"
#include "Editor/QualityList.h"
#include "Editor/SoundMeters.h"

#include <vector>

namespace idiophone {

class QualityPage final : public DeckPage {
public:
    explicit QualityPage(ProcessorView& view)
        : DeckPage("Quality"), quality(view),
          columns(std::vector<ParameterGroup>{{"Modes that sound", 0}, {"Budget", 1}}, view) {
        showParts(*this, quality, columns, counts, ramp, meters);
    }

    void refresh() override {
        quality.refresh();
        columns.refresh();
    }
    void showSound(const SoundFrame& frame) override {
        counts.show(frame);
        ramp.show(frame);
        meters.show(frame);
    }

    void resized() override {
        auto area = getLocalBounds().reduced(padding);
        const bool low = getHeight() < 360;
        quality.setBounds(area.removeFromTop(low ? 24 : 26));
        columns.setBounds(area.removeFromTop(low ? 82 : 112));
        counts.setBounds(area.removeFromTop(low ? 48 : 50));
        meters.setBounds(area.removeFromBottom(51));
        ramp.setBounds(area.withTrimmedBottom(2));
    }

private:
    QualityList quality;
    ParameterColumns columns;
    ModeCounts counts;
    BudgetRamp ramp;
    SoundMeters meters;
};

} // namespace idiophone
