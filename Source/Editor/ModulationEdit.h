// Modulation of a parameter as its control shows and changes it.
#pragma once

#include "Editor/ProcessorView.h"
#include "Parameters/ModulationTable.h"

#include <juce_gui_basics/juce_gui_basics.h>
#include <optional>

namespace idiophone {

/// Returns the lowest and highest value that modulation gives the parameter; nothing if no route
/// moves it.
std::optional<ModulatedRange> shownModulation(const ParameterView& parameters, ParameterId target);

/// Returns "Modulated by LFO 1 and Wheel", or an empty text.
juce::String modulationSentence(const ParameterView& parameters, ParameterId target);

/// Adds the items that modulate the parameter by a source, each as one step of undo, and those that
/// end this. Adds none for a parameter that modulation cannot move.
void addModulationItems(juce::PopupMenu& menu, ParameterId target, ProcessorView& view);

} // namespace idiophone
