// What the parameters ask of the synthesiser.
#pragma once

#include "Object/Material.h"
#include "Parameters/ParameterTable.h"
#include "Synth/SynthesisSettings.h"

namespace idiophone {

/// The settings that the values stand for, with every frequency bent by so many semitones on top of
/// "tune". Any thread.
SynthesisSettings synthesisSettings(const ParameterValues& values, double bendSemitones = 0);

/// The library's material where one is chosen to be live, else nullptr. Any thread.
const Material* chosenLibraryMaterial(const ParameterValues& values);

} // namespace idiophone
