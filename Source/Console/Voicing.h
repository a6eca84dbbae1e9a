// Makes a keyboard even, as a maker voices bars: a gain for each key.
#pragma once

#include "Instrument/Preset.h"
#include "Object/Result.h"

#include <vector>

namespace idiophone {

/// Returns the `voicingDb` that makes a preset's keys equally loud. The loudness of a key is that
/// of the loudest 400 ms of its note, the mean over a soft and a loud velocity, without level and
/// room. The preset's own voicing is ignored. A silent key has 0 dB. Errors: those of
/// Instrument::build.
Result<std::vector<double>> evenVoicingDb(Preset preset);

} // namespace idiophone
