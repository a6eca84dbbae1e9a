// Makes a new sound near the current one: random steps of the parameters that shape it, within
// musical bounds (ParameterInfo::mutation). It keeps the pitch, and so stiffness, density, size and
// thickness; it also keeps quality settings and the way keys play.
#pragma once

#include "Instrument/Instrument.h"
#include "Parameters/ParameterTable.h"

#include <cstdint>
#include <memory>

namespace idiophone {

/// Returns the values after random steps, each uniform within its parameter's step times `strength`
/// (0 to 1) and reflected at its bounds. A value beyond its bounds moves no further away. Material
/// and mallet become custom ones, which start from the current figures. `level` follows the
/// predicted loudness down without limit, and up by at most 6 dB: never above the greater of its
/// old value and 0 dB. `now` must come from `preset`.
///
/// The same arguments give the same values. Takes as long as a few predictions of loudness
/// (LoudnessMatch.h): not for the audio thread.
ParameterValues mutated(const ParameterValues& now,
                        const std::shared_ptr<const Instrument>& instrument,
                        const Preset& preset,
                        double strength,
                        std::uint32_t seed);

} // namespace idiophone
