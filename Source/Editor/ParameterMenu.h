// What a right click on a parameter offers: a value to type, its default, a MIDI controller.
#pragma once

#include "Editor/ProcessorView.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// The menu as things are now; its items refer to the view. Without `typeValue` nothing can be
/// typed.
juce::PopupMenu
parameterMenu(const ParameterInfo& info, ProcessorView& view, std::function<void()> typeValue);

/// What the parameter does to the sound, and for a number its range, with the unit.
juce::String parameterTooltip(const ParameterInfo& info);

/// "Moved by MIDI controller 21", what a parameter waits for, or nothing.
juce::String controllerSentence(const ParameterInfo& info, const MidiLearnView& midi);

/// Whether a key asks for the menu of what has the focus: Shift+F10, or the menu key where JUCE
/// tells of it.
bool asksForMenu(const juce::KeyPress& key);

} // namespace idiophone
