// Groups of parameters under headings, in two columns.
#pragma once

#include "Editor/ParameterControl.h"

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
    ParameterColumns(std::span<const ParameterGroup> groups, ProcessorView& view);

    void refresh();
    void paint(juce::Graphics& g) override;
    void resized() override;

private:
    struct Group {
        juce::String title;
        int column;
        std::vector<std::unique_ptr<ParameterControl>> controls;
        juce::Rectangle<int> heading;
    };
    std::vector<Group> groups;
};

} // namespace idiophone
