// How hard a hand must scrape to be as loud as strikes.
#pragma once

#include "Instrument/Instrument.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <memory>
#include <vector>

namespace idiophone {

/// Returns the factors [slots] of a hand's contact force. A scrape of some newtons is 37 to 75 dB
/// weaker than a mallet strike, and strikes decide the level of presets whose keys strike. With
/// these factors a drag at 0.5 m/s is nearly as loud as a strike there, as predicted for the
/// preset's own values; later changes of values stay audible. A factor is 1 if the keys themselves
/// scrape or roll, or if nothing sounds. The surface must be valid. Not for the audio thread.
std::vector<double> handStrengths(const std::shared_ptr<const Instrument>& instrument,
                                  const Surface& surface,
                                  double sampleRateHz,
                                  const ParameterValues& own);

} // namespace idiophone
