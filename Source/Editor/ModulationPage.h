// The page of modulation: eight rows, each with a source, the parameter that it moves, and how far.
#pragma once

#include "Editor/DeckPage.h"
#include "Editor/Look.h"
#include "Editor/ParameterControl.h"
#include "Editor/Utf8.h"
#include "Parameters/ModulationTable.h"

#include <algorithm>
#include <array>
#include <memory>

namespace idiophone {

class ModulationPage final : public DeckPage {
public:
    explicit ModulationPage(ProcessorView& view) : DeckPage("Modulate") {
        for (std::size_t row = 0; row < routeCount; ++row) {
            const auto& route = modulationRoutes[row];
            const std::array columns{route.source, route.target, route.amount};
            for (std::size_t column = 0; column < columns.size(); ++column) {
                auto& control = rows[row][column];
                control = std::make_unique<ParameterControl>(parameterInfo(columns[column]), view,
                                                             ParameterControl::Shape::bare);
                addAndMakeVisible(*control);
            }
        }
    }

    void refresh() override {
        for (auto& row : rows)
            for (auto& control : row)
                control->refresh();
    }

    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::text));
        g.setFont(Look::headingFont());
        for (const auto& control : rows.front())
            g.drawText(fromUtf8(control->parameter().shortName),
                       control->getBounds().withY(padding).withHeight(headingHeight),
                       juce::Justification::centredLeft);
    }

    void resized() override {
        auto area = getLocalBounds().reduced(padding).withTrimmedTop(headingHeight);
        const int height = std::min(area.getHeight() / static_cast<int>(routeCount), highestRow);
        for (auto& row : rows) {
            auto line = area.removeFromTop(height).reduced(0, (height - controlHeight) / 2);
            const int width = line.getWidth();
            row[0]->setBounds(line.removeFromLeft(width * 25 / 100));
            row[1]->setBounds(line.removeFromLeft(width * 39 / 100).withTrimmedLeft(gap));
            row[2]->setBounds(line.withTrimmedLeft(gap));
        }
    }

private:
    static constexpr int headingHeight = 18, highestRow = 38, controlHeight = 24, gap = 6;

    std::array<std::array<std::unique_ptr<ParameterControl>, 3>, routeCount> rows;
};

} // namespace idiophone
