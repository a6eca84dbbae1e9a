#include "Editor/ParameterMenu.h"

#include "Editor/ModulationEdit.h"
#include "Editor/NamedEdit.h"
#include "Editor/Utf8.h"

namespace idiophone {
namespace {

/// "23.90 GPa", in the plain display "56 (23.90 GPa)".
juce::String valueText(const ParameterInfo& info, double value, ValueDisplay display) {
    const auto withUnit = fromUtf8(formatParameter(info, value));
    return info.isPhysical && display == ValueDisplay::plain
               ? fromUtf8(formatParameter(info, value, display)) + " (" + withUnit + ")"
               : withUnit;
}

} // namespace

juce::PopupMenu parameterMenu(const ParameterInfo& info,
                              ProcessorView& view,
                              ValueDisplay display,
                              ParameterMenuActions actions) {
    auto& midi = view.controllers;
    const auto parameter = info.parameter;
    const bool live = view.parameters.isLive(parameter);
    juce::PopupMenu menu;
    menu.addSectionHeader(fromUtf8(info.name) + ": " +
                          valueText(info, view.parameters.effectiveValue(parameter), display));
    if (actions.typeValue != nullptr)
        menu.addItem("Type a value...", live, false, std::move(actions.typeValue));
    const auto addValue = [&](const juce::String& name, double value) {
        menu.addItem(name + valueText(info, value, display), live, false, [&info, &view, value] {
            const NamedEdit step(view.history, info.name);
            view.parameters.changeOnce(info.parameter, value);
        });
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
    if (actions.listControllers != nullptr)
        menu.addItem("MIDI controllers...", std::move(actions.listControllers));
    addModulationItems(menu, parameter, view);
    return menu;
}

juce::String parameterTooltip(const ParameterInfo& info, ValueDisplay display) {
    const auto description = fromUtf8(info.description);
    if (info.scale == ParameterScale::onOff || info.scale == ParameterScale::choice)
        return description;
    const auto range = [&](ValueDisplay shown) {
        return fromUtf8(formatParameter(info, info.minimum, shown) + " to " +
                        formatParameter(info, info.maximum, shown));
    };
    const auto units = range(ValueDisplay::units);
    return description + "\n" +
           (info.isPhysical && display == ValueDisplay::plain ? range(display) + " (" + units + ")"
                                                              : units);
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
