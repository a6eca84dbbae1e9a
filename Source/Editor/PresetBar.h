// The head of the window: the product's name and the preset, with its neighbours one click away.
#pragma once

#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

class PresetBar final : public juce::Component {
public:
    explicit PresetBar(ProcessorView& view);

    void refresh();

    void paint(juce::Graphics& g) override;
    void resized() override;

private:
    void step(int by);

    ProcessorView& view;
    juce::ComboBox list;
    juce::TextButton previous{"<"}, next{">"};
};

} // namespace idiophone
