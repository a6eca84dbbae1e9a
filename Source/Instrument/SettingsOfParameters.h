// What the parameters ask of the synthesiser.
#pragma once

#include "Object/Material.h"
#include "Parameters/ParameterTable.h"
#include "Synth/SynthesisSettings.h"

#include <array>

namespace idiophone {

/// What the custom material has, all live.
inline constexpr std::array materialFigures{
    ParameterId::youngsModulus, ParameterId::density, ParameterId::fluidDamping,
    ParameterId::viscoelasticDamping, ParameterId::lossFactor};

/// The values with that material as the custom one, its figures held to the parameters' ranges. Its
/// Poisson ratio and contact figures are not among them. Any thread.
ParameterValues withCustomMaterial(ParameterValues values, const Material& material);

/// The settings that the values stand for, with every frequency bent by so many semitones on top of
/// "tune". Any thread.
SynthesisSettings synthesisSettings(const ParameterValues& values, double bendSemitones = 0);

/// The library's material where one is chosen to be live, else nullptr. Any thread.
const Material* chosenLibraryMaterial(const ParameterValues& values);

} // namespace idiophone
