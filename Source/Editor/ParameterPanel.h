// All parameters of the table in groups, the groups in columns.
#pragma once

#include "Editor/ParameterControl.h"

#include <memory>
#include <vector>

namespace idiophone {

class ParameterPanel final : public juce::Component {
public:
    explicit ParameterPanel(ProcessorView& view);

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
    std::vector<juce::Rectangle<int>> columns;
};

} // namespace idiophone
