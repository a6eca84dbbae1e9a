// A new sound near the one that plays: random steps of the parameters that shape it, within musical
// bounds (ParameterInfo::mutation). Pitch, and so stiffness, density, size and thickness, quality
// and what the keys do stay as they are.
#pragma once

#include "Instrument/Instrument.h"
#include "Parameters/ParameterTable.h"

#include <cstdint>
#include <memory>

namespace idiophone {

/// The values moved by random steps, each uniform within its own step times `strength` (0 to 1) and
/// turned back at its bounds; a value that lies beyond its bounds already goes no further. The
/// material and the mallet become custom ones, which start from the figures of what is played.
/// `level` follows the predicted loudness down without limit and up by 6 dB at most, never above
/// what it was or 0 dB, whichever is more. `preset` is what `now` was loaded from.
///
/// The same arguments give the same values. It takes as long as a few predictions of loudness
/// (LoudnessMatch.h): not for the audio thread.
ParameterValues mutated(const ParameterValues& now,
                        const std::shared_ptr<const Instrument>& instrument,
                        const Preset& preset,
                        double strength,
                        std::uint32_t seed);

} // namespace idiophone
