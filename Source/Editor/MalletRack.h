// The row of mallets; a click selects one.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <vector>

namespace idiophone {

class MalletRack final : public juce::Component {
public:
    explicit MalletRack(ProcessorView& view);

    void refresh();

    void resized() override;

private:
    ProcessorView& view;
    std::vector<std::unique_ptr<juce::Button>> mallets;
    int shown = -1;
};

} // namespace idiophone
