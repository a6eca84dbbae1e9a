#include "Editor/StrikePage.h"

#include <vector>

namespace idiophone {
namespace {

constexpr int rackHeight = 62;

std::vector<ParameterGroup> groups() {
    using enum ParameterId;
    return {{"Mallet", 0, {malletHardness, malletMass, malletRadius, malletExponent}},
            {"Place", 1}};
}

} // namespace

StrikePage::StrikePage(ProcessorView& view)
    : DeckPage("Strike"), rack(view), columns(groups(), view) {
    addAndMakeVisible(rack);
    addAndMakeVisible(columns);
}

void StrikePage::refresh() {
    rack.refresh();
    columns.refresh();
}

void StrikePage::resized() {
    auto area = getLocalBounds().reduced(padding);
    rack.setBounds(area.removeFromTop(rackHeight));
    area.removeFromTop(6);
    columns.setBounds(area);
}

} // namespace idiophone
