// The page of the strike: the mallet, its figures and velocity curve, and the strike place.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/Look.h"
#include "Editor/MalletRack.h"
#include "Editor/ParameterColumns.h"
#include "Editor/VelocityGraph.h"

#include <vector>

namespace idiophone {

class StrikePage final : public DeckPage {
public:
    explicit StrikePage(ProcessorView& view)
        : DeckPage("Strike"), rack(view), columns(groups(), view), graph(view) {
        showParts(*this, rack, columns, graph);
    }

    void refresh() override {
        rack.refresh();
        columns.refresh();
        graph.refresh();
    }

    void showSound(const SoundFrame& frame) override { graph.showStrike(frame.velocity); }

    void resized() override {
        auto area = getLocalBounds().reduced(padding);
        rack.setBounds(area.removeFromTop(62));
        columns.setBounds(area.withTrimmedTop(6));
        // Beside the velocity curve, which is the last of the other column.
        graph.setBounds((columns.areaBelow(1) + columns.getPosition()).withTrimmedTop(4));
    }

private:
    static std::vector<ParameterGroup> groups() {
        using enum ParameterId;
        return {{"Mallet", 0, {malletHardness, malletMass, malletRadius, malletExponent}},
                {"Place", 1}};
    }

    MalletRack rack;
    ParameterColumns columns;
    VelocityGraph graph;
};

} // namespace idiophone
