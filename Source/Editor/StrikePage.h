// The page of the strike: the mallet, its figures, and the strike place.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/Look.h"
#include "Editor/MalletRack.h"
#include "Editor/ParameterColumns.h"

#include <vector>

namespace idiophone {

class StrikePage final : public DeckPage {
public:
    explicit StrikePage(ProcessorView& view)
        : DeckPage("Strike"), rack(view), columns(groups(), view) {
        showParts(*this, rack, columns);
    }

    void refresh() override {
        rack.refresh();
        columns.refresh();
    }

    void resized() override {
        auto area = getLocalBounds().reduced(padding);
        rack.setBounds(area.removeFromTop(62));
        columns.setBounds(area.withTrimmedTop(6));
    }

private:
    static std::vector<ParameterGroup> groups() {
        using enum ParameterId;
        return {{"Mallet", 0, {malletHardness, malletMass, malletRadius, malletExponent}},
                {"Place", 1}};
    }

    MalletRack rack;
    ParameterColumns columns;
};

} // namespace idiophone
