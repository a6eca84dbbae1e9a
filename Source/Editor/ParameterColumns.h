// Groups of parameters under headings, in two columns whose rows are equally high.
#pragma once

#include "Editor/Look.h"
#include "Editor/ParameterControl.h"
#include "Editor/Utf8.h"

#include <algorithm>
#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace idiophone {

/// A group of parameters, in one of the columns.
struct ParameterGroup {
    std::string_view name;               ///< ParameterInfo::group
    int column;                          ///< 0 or 1
    std::vector<ParameterId> first = {}; ///< before the others, which keep the table's order
};

class ParameterColumns final : public juce::Component {
public:
    ParameterColumns(std::span<const ParameterGroup> wanted, ProcessorView& view) {
        for (const auto& [name, column, first] : wanted) {
            auto order = first;
            for (const auto& info : parameterTable())
                if (info.group == name && std::ranges::find(first, info.parameter) == first.end())
                    order.push_back(info.parameter);
            std::erase_if(order, [&](ParameterId one) { return !view.parameters.isOffered(one); });
            if (order.empty())
                continue;
            Group group{.title = fromUtf8(name), .column = column, .controls = {}, .heading = {}};
            for (const auto parameter : order) {
                group.controls.push_back(
                    std::make_unique<ParameterControl>(parameterInfo(parameter), view));
                addAndMakeVisible(*group.controls.back());
            }
            groups.push_back(std::move(group));
        }
    }

    /// The rest of a column below its last row.
    juce::Rectangle<int> areaBelow(int column) const {
        auto area = columnArea(column);
        for (const auto& group : groups)
            if (group.column == column)
                area.setTop(group.controls.back()->getBottom());
        return area;
    }

    void refresh() {
        for (auto& group : groups)
            for (auto& control : group.controls)
                control->refresh();
    }
    void paint(juce::Graphics& g) override {
        g.setColour(colourOf(*this, LookColour::text));
        g.setFont(Look::headingFont());
        for (const auto& group : groups)
            g.drawText(group.title, group.heading, juce::Justification::centredLeft);
    }
    void resized() override {
        const int rowHeight = std::min(fittingRow(0), fittingRow(1));
        for (int column = 0; column < columnCount; ++column) {
            auto area = columnArea(column);
            for (auto& group : groups) {
                if (group.column != column)
                    continue;
                group.heading = area.removeFromTop(headingHeight);
                for (auto& control : group.controls)
                    control->setBounds(area.removeFromTop(rowHeight));
            }
        }
    }

private:
    static constexpr int columnCount = 2, gap = 16, headingHeight = 20;
    static constexpr int lowestRow = 30, highestRow = 52;

    juce::Rectangle<int> columnArea(int column) const {
        const int width = (getWidth() - (columnCount - 1) * gap) / columnCount;
        return getLocalBounds().withX(column * (width + gap)).withWidth(width);
    }
    int fittingRow(int column) const {
        int headings = 0, rows = 0;
        for (const auto& group : groups)
            if (group.column == column) {
                ++headings;
                rows += static_cast<int>(group.controls.size());
            }
        return std::clamp((getHeight() - headings * headingHeight) / std::max(rows, 1), lowestRow,
                          highestRow);
    }

    struct Group {
        juce::String title;
        int column;
        std::vector<std::unique_ptr<ParameterControl>> controls;
        juce::Rectangle<int> heading;
    };
    std::vector<Group> groups;
};

} // namespace idiophone
