// The context menu of a parameter and its texts: type a value, reset it, learn a MIDI controller.
#pragma once

#include "Editor/ProcessorView.h"

#include <functional>
#include <juce_gui_basics/juce_gui_basics.h>

namespace idiophone {

/// Actions of the menu beyond the view. Without a function there is no item for it.
struct ParameterMenuActions {
    std::function<void()> typeValue;
    std::function<void()> listControllers;
};

/// Builds the menu for the current state; its items refer to the view.
juce::PopupMenu parameterMenu(const ParameterInfo& info,
                              ProcessorView& view,
                              ValueDisplay display,
                              ParameterMenuActions actions);

/// The parameter's description; for a number also its range, of a plain display with and without
/// units.
juce::String parameterTooltip(const ParameterInfo& info, ValueDisplay display);

/// "Moved by MIDI controller 21", a request to move one while learning, or empty.
juce::String controllerSentence(const ParameterInfo& info, const MidiLearnView& midi);

/// Whether a key opens the context menu: Shift+F10, or the menu key where JUCE reports it.
bool asksForMenu(const juce::KeyPress& key);

} // namespace idiophone
