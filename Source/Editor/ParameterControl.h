// One parameter in the window: its name, its value to read and to type, and a slider, switch or
// list to change it.
#pragma once

#include "Editor/ChoiceList.h"
#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>

namespace idiophone {

class ParameterControl final : public juce::Component {
public:
    ParameterControl(const ParameterInfo& info, ProcessorView& view);

    /// Shows what the processor has, if that has changed.
    void refresh();

    void resized() override;
    void lookAndFeelChanged() override;

private:
    void makeSlider();
    void makeSwitch();
    void makeValueText();
    void changeOnce(double value);
    void typed();
    void placeName(juce::Rectangle<int> area);

    const ParameterInfo& info;
    ProcessorView& view;
    double shown;
    bool isLive = true;
    juce::Label name, value;
    std::unique_ptr<juce::Slider> slider;
    std::unique_ptr<juce::ToggleButton> toggle;
    std::unique_ptr<ChoiceList> list;
};

} // namespace idiophone
