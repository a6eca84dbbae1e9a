// Parameters under headings, in two columns.
#pragma once

#include "Editor/ParameterControl.h"

#include <memory>
#include <span>
#include <string_view>
#include <vector>

namespace idiophone {

/// The parameters of the table that name it as theirs.
struct ParameterGroup {
    std::string_view name;               ///< ParameterInfo::group
    int column;                          ///< 0 or 1
    std::vector<ParameterId> first = {}; ///< the others follow in the table's order
};

class ParameterColumns final : public juce::Component {
public:
    ParameterColumns(std::span<const ParameterGroup> groups, ProcessorView& view);

    /// Shows what the processor has, where that has changed.
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
