#include "Editor/ParameterControl.h"

#include "Editor/ModulationEdit.h"
#include "Editor/NamedEdit.h"
#include "Editor/Utf8.h"

#include <limits>

namespace idiophone {
namespace {

/// Why a parameter has no effect on the current sound.
juce::String idleSentence(ParameterId parameter) {
    return parameter == ParameterId::keepPitch ? "No key that plays has a pitch to keep"
                                               : "The objects need a new analysis";
}

constexpr float markWidth = 11; ///< width of the controller's mark and its gap

} // namespace

ParameterControl::ParameterControl(const ParameterInfo& row,
                                   ProcessorView& processor,
                                   Shape inShape)
    : info(row), view(processor), shape(inShape), shown(std::numeric_limits<double>::quiet_NaN()),
      controlMenu(*this, row, processor),
      burst([this] { beginGesture(); }, [this] { endGesture(); }) {
    const auto title = fromUtf8(info.name);
    setTitle(title);
    if (shape != Shape::bare)
        addAndMakeVisible(name);
    if (info.scale == ParameterScale::onOff)
        makeSwitch();
    else if (info.scale == ParameterScale::choice)
        addAndMakeVisible(*(list = std::make_unique<ChoiceList>(info, view)));
    else
        makeSlider();
    setInterceptsMouseClicks(false, true); // only its parts take clicks
    addMouseListener(this, true);
    refresh();
}

// JUCE ends a drag when it destroys the slider. The burst, a later member, no longer exists then.
ParameterControl::~ParameterControl() {
    if (slider != nullptr)
        slider->onDragStart = slider->onDragEnd = nullptr;
}

void ParameterControl::makeSlider() {
    makeValueText();
    slider = std::make_unique<KeyedSlider>(info);
    slider->onReturn = controlMenu.typeValue = [this] { value.showEditor(); };
    if (shape == Shape::knob) {
        slider->setSliderStyle(juce::Slider::RotaryHorizontalVerticalDrag);
        name.setJustificationType(juce::Justification::centred);
        value.setJustificationType(juce::Justification::centred);
    }
    slider->setTitle(getTitle());
    slider->textFromValueFunction = [this](double number) { return textOf(number); };
    slider->onDragStart = [this] { beginDrag(); };
    slider->onDragEnd = [this] { endDrag(); };
    slider->onValueChange = [this] { slid(); };
    addAndMakeVisible(*slider);
}

void ParameterControl::makeSwitch() {
    toggle = std::make_unique<LeftClicked<juce::ToggleButton>>();
    toggle->setTitle(getTitle());
    toggle->onClick = [this] { changeTo(toggle->getToggleState() ? 1 : 0); };
    addAndMakeVisible(*toggle);
}

void ParameterControl::makeValueText() {
    value.setJustificationType(juce::Justification::centredRight);
    value.setEditable(true);
    value.setWantsKeyboardFocus(false); // Return on the slider opens it
    value.setTitle(getTitle());
    value.setTooltip("Click, or press Return on the slider, to type a value");
    value.onTextChange = [this] { typed(); };
    addAndMakeVisible(value);
}

// An edit, so that the step has the parameter's name if other figures become custom with it.
void ParameterControl::beginGesture() {
    view.history.beginEdit(info.name);
    view.parameters.beginChange(info.parameter);
}

void ParameterControl::endGesture() {
    view.parameters.endChange(info.parameter);
    view.history.endEdit();
}

// JUCE also reports a notch of the wheel as a drag.
void ParameterControl::beginDrag() {
    if (!slider->isPressed() || drags++ > 0)
        return;
    beginGesture(); // before a burst of clicks ends: one gesture
    burst.finish();
}

void ParameterControl::endDrag() {
    if (drags == 0 || --drags > 0)
        return;
    if (!slider->wasMoved()) // it may become a double click
        burst.extend();
    endGesture();
}

void ParameterControl::slid() {
    if (drags == 0)
        burst.extend();
    view.parameters.makeCustom(info.parameter);
    view.parameters.change(info.parameter, slider->getValue());
    refresh();
}

juce::String ParameterControl::textOf(double number) const {
    return fromUtf8(formatParameter(info, number, display));
}

void ParameterControl::changeTo(double number) {
    burst.finish();
    const NamedEdit step(view.history, info.name);
    view.parameters.changeOnce(info.parameter, number);
}

void ParameterControl::typed() {
    if (const auto parsed = parseParameter(info, value.getText().toStdString(), display))
        changeTo(*parsed);
    shown = std::numeric_limits<double>::quiet_NaN(); // so that refresh replaces the text
    refresh();
}

void ParameterControl::refresh() {
    if (list != nullptr)
        list->refresh();
    if (slider != nullptr)
        slider->setResetValue(view.parameters.presetValue(info.parameter));
    refreshController();
    refreshModulation();
    const double now = view.parameters.effectiveValue(info.parameter);
    const bool live = view.parameters.isLive(info.parameter);
    const auto displayNow = valueDisplayAround(*this);
    if (now == shown && live == isLive && display == displayNow)
        return;
    shown = now;
    isLive = live;
    display = displayNow;
    setEnabled(live);
    showTooltip();
    if (!value.isBeingEdited())
        value.setText(live ? textOf(now) : juce::String("re-analyse"), juce::dontSendNotification);
    if (slider != nullptr) {
        slider->setValue(now, juce::dontSendNotification);
        slider->setAlpha(live ? 1.0f : 0.4f);
    }
    if (toggle != nullptr) {
        toggle->setToggleState(now != 0, juce::dontSendNotification);
        toggle->setAlpha(live ? 1.0f : 0.4f);
    }
}

void ParameterControl::showTooltip() {
    auto text = parameterTooltip(info, display);
    if (!isLive)
        text << "\n" << idleSentence(info.parameter);
    if (const auto sentence = controllerSentence(info, view.controllers); sentence.isNotEmpty())
        text << "\n" << sentence;
    if (modulation.isNotEmpty())
        text << "\n" << modulation;
    name.setTooltip(text);
    if (slider != nullptr)
        slider->setTooltip(text);
    if (toggle != nullptr)
        toggle->setTooltip(text);
}

void ParameterControl::refreshController() {
    const auto& midi = view.controllers;
    const auto number = midi.controllerOf(info.parameter);
    const bool learning = midi.learningParameter() == info.parameter;
    if (number == controller && learning == isLearning)
        return;
    controller = number;
    isLearning = learning;
    showTooltip();
    setDescription(controllerSentence(info, midi));
    resized();
    repaint();
}

void ParameterControl::refreshModulation() {
    if (slider == nullptr)
        return;
    const auto range = shownModulation(view.parameters, info.parameter);
    Look::showModulation(
        *slider, range ? std::optional(juce::Range<double>(info.toNormalised(range->lowest),
                                                           info.toNormalised(range->highest)))
                       : std::nullopt);
    auto sentence = modulationSentence(view.parameters, info.parameter);
    if (sentence == modulation)
        return;
    modulation = std::move(sentence);
    slider->setDescription(modulation);
    showTooltip();
}

// When the mouse leaves the slider, the wheel gesture ends.
void ParameterControl::mouseExit(const juce::MouseEvent& event) {
    if (event.eventComponent == slider.get())
        burst.finish();
}

void ParameterControl::focusOfChildComponentChanged(FocusChangeType) {
    if (!hasKeyboardFocus(true))
        burst.finish();
}

void ParameterControl::paint(juce::Graphics& g) {
    if (!controller && !isLearning)
        return;
    const auto mark =
        juce::Rectangle<float>(markWidth - 4, markWidth - 4)
            .withCentre({(markWidth - 4) / 2,
                         shape == Shape::bare ? static_cast<float>(getHeight()) / 2
                                              : static_cast<float>(name.getBounds().getCentreY())});
    g.setColour(colourOf(*this, LookColour::accent));
    if (isLearning)
        g.drawEllipse(mark.reduced(0.75f), 1.5f);
    else
        g.fillEllipse(mark);
}

void ParameterControl::lookAndFeelChanged() {
    name.setColour(juce::Label::textColourId, colourOf(*this, LookColour::dimText));
}

void ParameterControl::placeName(juce::Rectangle<int> area) {
    if (controller || isLearning)
        area.removeFromLeft(juce::roundToInt(markWidth));
    const auto full = getTitle();
    const bool fits = juce::GlyphArrangement::getStringWidth(name.getFont(), full) <=
                      static_cast<float>(area.getWidth());
    name.setText(fits ? full : fromUtf8(info.shortName), juce::dontSendNotification);
    name.setBounds(area);
}

void ParameterControl::placeKnob() {
    auto area = getLocalBounds();
    placeName(area.removeFromTop(18));
    value.setBounds(area.removeFromBottom(18));
    slider->setBounds(area);
}

void ParameterControl::placeBare() {
    auto area = getLocalBounds();
    if (controller || isLearning)
        area.removeFromLeft(juce::roundToInt(markWidth));
    if (list != nullptr)
        return list->setBounds(area);
    value.setBounds(area.removeFromRight(58));
    slider->setBounds(area);
}

void ParameterControl::resized() {
    if (shape == Shape::bare)
        return placeBare();
    auto area = getLocalBounds();
    if (slider == nullptr) {
        area.setHeight(juce::jmin(area.getHeight(), 25));
        if (list != nullptr)
            list->setBounds(area.removeFromRight(area.getWidth() * 3 / 5).reduced(0, 1));
        else
            toggle->setBounds(area.removeFromRight(40));
        placeName(area);
        return;
    }
    if (shape == Shape::knob)
        return placeKnob();
    auto line = area.removeFromTop(17);
    value.setBounds(line.removeFromRight(juce::jmax(84, line.getWidth() * 3 / 8)));
    placeName(line);
    slider->setBounds(area.withHeight(juce::jmin(area.getHeight(), 22)));
}

} // namespace idiophone
