#include "Editor/ParameterMenu.h"

#include "Editor/Utf8.h"

namespace idiophone {
namespace {

juce::String valueText(const ParameterInfo& info, double value) {
    return fromUtf8(formatParameter(info, value));
}

} // namespace

juce::PopupMenu
parameterMenu(const ParameterInfo& info, ProcessorView& view, std::function<void()> typeValue) {
    auto& midi = view.controllers;
    const auto parameter = info.parameter;
    const bool live = view.parameters.isLive(parameter);
    juce::PopupMenu menu;
    menu.addSectionHeader(fromUtf8(info.name) + ": " +
                          valueText(info, view.parameters.effectiveValue(parameter)));
    if (typeValue != nullptr)
        menu.addItem("Type a value...", live, false, std::move(typeValue));
    const auto addValue = [&](const juce::String& name, double value) {
        menu.addItem(name + valueText(info, value), live, false,
                     [&info, &view, value] { view.parameters.changeOnce(info.parameter, value); });
    };
    addValue("Reset to ", view.parameters.presetValue(parameter));
    addValue("Default: ", info.defaultValue);
    menu.addSeparator();
    if (midi.learningParameter() == parameter)
        menu.addItem("Stop waiting for a MIDI controller", [&midi] { midi.stopLearning(); });
    else
        menu.addItem("Learn a MIDI controller",
                     [&midi, parameter] { midi.learnController(parameter); });
    if (const auto number = midi.controllerOf(parameter))
        menu.addItem("Forget MIDI controller " + juce::String(*number),
                     [&midi, parameter] { midi.forgetController(parameter); });
    return menu;
}

juce::String parameterTooltip(const ParameterInfo& info) {
    const auto description = fromUtf8(info.description);
    if (info.scale == ParameterScale::onOff || info.scale == ParameterScale::choice)
        return description;
    const auto text = [&](double value) { return fromUtf8(formatParameter(info, value)); };
    return description + "\n" + text(info.minimum) + " to " + text(info.maximum);
}

juce::String controllerSentence(const ParameterInfo& info, const MidiLearnView& midi) {
    if (midi.learningParameter() == info.parameter)
        return "Move the MIDI controller to assign to this parameter";
    if (const auto number = midi.controllerOf(info.parameter))
        return "Moved by MIDI controller " + juce::String(*number);
    return {};
}

bool asksForMenu(const juce::KeyPress& key) {
#if JUCE_WINDOWS
    constexpr int menuKey = 0x1005d;
#elif JUCE_LINUX
    constexpr int menuKey = 0x10000067;
#else
    constexpr int menuKey = 0;
#endif
    return key == juce::KeyPress(juce::KeyPress::F10Key, juce::ModifierKeys::shiftModifier, 0) ||
           (menuKey != 0 && key.getKeyCode() == menuKey);
}

} // namespace idiophone
