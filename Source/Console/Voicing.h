// Makes a keyboard even, as a maker voices bars: a gain for each key.
#pragma once

#include "Instrument/Preset.h"
#include "Object/Result.h"

#include <vector>

namespace idiophone {

/// The `voicingDb` with which a preset's keys lie on a straight line of loudness over the keyboard,
/// which climbs or falls by at most 3 dB: the line of least squares through their own. A key is as
/// loud as the loudest 400 ms of its note, the mean over a soft and a loud velocity, without level
/// and room. A voicing that the preset has counts for nothing. A silent key has 0 dB. Errors: those
/// of Instrument::build.
Result<std::vector<double>> evenVoicingDb(Preset preset);

} // namespace idiophone
