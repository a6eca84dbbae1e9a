// Makes a keyboard even, as a maker voices bars: a gain for each key.
#pragma once

#include "Instrument/ObjectLibrary.h"
#include "Instrument/Preset.h"

#include <vector>

namespace idiophone {

/// The `voicingDb` with which a preset's keys lie on a straight line of loudness over the keyboard,
/// which climbs or falls by at most 6 dB: the line of least squares through their own. A key's
/// loudness is predicted (PhrasePrediction.h) as the mean over its velocities; a voicing that the
/// preset has counts for nothing. A silent key has 0 dB. Errors: those of Instrument::build. Not
/// for the audio thread.
Result<std::vector<double>>
evenVoicingDb(Preset preset, ObjectLibrary& library, double sampleRateHz);

} // namespace idiophone
