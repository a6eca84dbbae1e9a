#include "Editor/ParameterPanel.h"

#include "Editor/DarkLook.h"

#include <initializer_list>

namespace idiophone {
namespace {

constexpr int columnCount = 4, gap = 8, padding = 10, headingHeight = 21;

struct Layout {
    const char* title;
    int column;
    std::initializer_list<ParameterId> parameters;
};

using enum ParameterId;
const Layout layouts[] = {
    {"Material",
     0,
     {material, youngsModulus, density, fluidDamping, viscoelasticDamping, lossFactor, size,
      thickness}},
    {"Strike", 0, {strikeAlong, strikeAcross, strikeSpread}},
    {"Mallet",
     1,
     {mallet, malletHardness, malletMass, malletRadius, malletSpeed, velocityCurve, chatter,
      modalPulse}},
    {"Scrape and roll", 2, {contact, contactForce, contactSpeed, roughness, rollCoupling}},
    {"Playing", 2, {letRing, releaseTime, tune, bendRange, motorSpeed, motorDepth}},
    {"Output", 3, {level, radiation, width, matchLoudness, bypass}},
    {"Quality", 3, {tau, qualitySlope, modeBudget, compression}},
};

} // namespace

ParameterPanel::ParameterPanel(ProcessorView& view) {
    for (const auto& layout : layouts) {
        Group group{.title = layout.title, .column = layout.column, .controls = {}, .heading = {}};
        for (const auto parameter : layout.parameters) {
            group.controls.push_back(
                std::make_unique<ParameterControl>(parameterInfo(parameter), view));
            addAndMakeVisible(*group.controls.back());
        }
        groups.push_back(std::move(group));
    }
}

void ParameterPanel::refresh() {
    for (auto& group : groups)
        for (auto& control : group.controls)
            control->refresh();
}

void ParameterPanel::paint(juce::Graphics& g) {
    g.setColour(palette::panel);
    for (const auto& column : columns)
        g.fillRoundedRectangle(column.toFloat(), 6);
    g.setColour(palette::text);
    g.setFont(DarkLook::headingFont());
    for (const auto& group : groups)
        g.drawText(group.title, group.heading, juce::Justification::centredLeft);
}

void ParameterPanel::resized() {
    constexpr int mostRows = 11, mostHeadings = 2;
    const int rowHeight =
        juce::jlimit(30, 52, (getHeight() - 2 * padding - mostHeadings * headingHeight) / mostRows);
    columns.clear();
    const int width = (getWidth() - (columnCount - 1) * gap) / columnCount;
    for (int column = 0; column < columnCount; ++column) {
        columns.push_back(getLocalBounds().withX(column * (width + gap)).withWidth(width));
        auto area = columns.back().reduced(padding);
        for (auto& group : groups) {
            if (group.column != column)
                continue;
            group.heading = area.removeFromTop(headingHeight);
            for (auto& control : group.controls)
                control->setBounds(area.removeFromTop(rowHeight));
        }
    }
}

} // namespace idiophone
