// One parameter in the window: its name, its value to read and to type, a slider, switch or list to
// change it, and a mark where a MIDI controller does.
#pragma once

#include "Editor/ChoiceList.h"
#include "Editor/GestureBurst.h"
#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <optional>

namespace idiophone {

class ParameterControl final : public juce::Component {
public:
    ParameterControl(const ParameterInfo& info, ProcessorView& view);

    /// Shows what the processor has, if that has changed.
    void refresh();

    /// What a right click or Shift+F10 shows.
    juce::PopupMenu menu();

    void resized() override;
    void paint(juce::Graphics& g) override;
    void mouseDown(const juce::MouseEvent& event) override;
    void mouseExit(const juce::MouseEvent& event) override;
    void focusOfChildComponentChanged(FocusChangeType cause) override;
    bool keyPressed(const juce::KeyPress& key) override;
    void lookAndFeelChanged() override;

private:
    void makeSlider();
    void makeSwitch();
    void makeValueText();
    void beginDrag();
    void endDrag();
    void slid();
    void changeTo(double value);
    void typed();
    void placeName(juce::Rectangle<int> area);
    void refreshController();
    void showTooltip();
    void showMenu();

    const ParameterInfo& info;
    ProcessorView& view;
    double shown;
    bool isLive = true;
    bool isLearning = false;
    std::optional<int> controller; ///< that moves it
    juce::Label name, value;
    std::unique_ptr<juce::Slider> slider;
    std::unique_ptr<juce::ToggleButton> toggle;
    std::unique_ptr<ChoiceList> list;
    bool isDragged = false;
    GestureBurst burst; ///< of the mouse wheel or a key
};

} // namespace idiophone
