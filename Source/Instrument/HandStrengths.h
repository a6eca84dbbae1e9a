// How hard a hand must scrape to be as loud as strikes.
#pragma once

#include "Instrument/Phrase.h"
#include "Parameters/ParameterTable.h"

#include <vector>

namespace idiophone {

/// Returns the factors [slots] of the force of a hand on the phrase's instrument and surface. A
/// scrape of some newtons is 37 to 75 dB weaker than a mallet strike, and strikes decide the level
/// of presets whose keys strike. With these factors a drag at 0.5 m/s is nearly as loud as a strike
/// there, as predicted for the preset's own values; later changes of values stay audible. A factor
/// is 1 if the keys themselves scrape or roll, or if nothing sounds. Not for the audio thread.
std::vector<double> handStrengths(const Phrase& phrase, const ParameterValues& own);

} // namespace idiophone
