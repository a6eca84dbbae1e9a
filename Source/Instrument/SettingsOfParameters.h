// What the parameters ask of the synthesiser.
#pragma once

#include "Parameters/ParameterTable.h"
#include "Synth/SynthesisSettings.h"

namespace idiophone {

/// The settings that the values stand for, with every frequency bent by so many semitones on top of
/// "tune". Any thread.
SynthesisSettings synthesisSettings(const ParameterValues& values, double bendSemitones = 0);

} // namespace idiophone
