// The control of one parameter: its name, an editable value, and a slider, switch or list. A mark
// shows that a MIDI controller moves it, and a line beside the slider how far modulation does.
#pragma once

#include "Editor/ChoiceList.h"
#include "Editor/ControlMenu.h"
#include "Editor/GestureBurst.h"
#include "Editor/KeyedSlider.h"
#include "Editor/Look.h"
#include "Editor/ProcessorView.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <memory>
#include <optional>

namespace idiophone {

class ParameterControl final : public juce::Component {
public:
    enum class Shape {
        row,  ///< name and value above a slider, or beside a switch or list
        knob, ///< name above a knob, value below; for parameters with a slider
        bare  ///< without a name: a list, or a slider with the value beside it
    };

    ParameterControl(const ParameterInfo& info, ProcessorView& view, Shape shape = Shape::row);
    ~ParameterControl() override;

    void refresh();
    const ParameterInfo& parameter() const { return info; }

    /// The menu for a right click or Shift+F10.
    juce::PopupMenu menu() const { return controlMenu.popup(); }

    void resized() override;
    void paint(juce::Graphics& g) override;
    void mouseExit(const juce::MouseEvent& event) override;
    void focusOfChildComponentChanged(FocusChangeType cause) override;
    void lookAndFeelChanged() override;

private:
    void makeSlider();
    void makeSwitch();
    void makeValueText();
    void beginGesture();
    void endGesture();
    void beginDrag();
    void endDrag();
    void slid();
    juce::String textOf(double value) const;
    void changeTo(double value);
    void typed();
    void placeName(juce::Rectangle<int> area);
    void placeKnob();
    void refreshController();
    void refreshModulation();
    void placeBare();
    void showTooltip();

    const ParameterInfo& info;
    ProcessorView& view;
    Shape shape;
    double shown;
    ValueDisplay display = ValueDisplay::plain;
    bool isLive = true;
    bool isLearning = false;
    std::optional<int> controller; ///< number of the MIDI controller that moves it
    juce::String modulation;       ///< says what modulates it
    TextLabel name, value;
    std::unique_ptr<KeyedSlider> slider;
    std::unique_ptr<juce::ToggleButton> toggle;
    std::unique_ptr<ChoiceList> list;
    ControlMenu controlMenu;
    int drags = 0;      ///< drags under way: a double click makes one within its press
    GestureBurst burst; ///< joins steps of the mouse wheel or a key into one gesture
};

} // namespace idiophone
