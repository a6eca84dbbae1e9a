// Chooses a mallet and level for an instrument that nobody has set by ear: audible, and as loud as
// the factory presets.
#pragma once

#include "Instrument/Instrument.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <memory>

namespace idiophone {

/// These functions are not for the audio thread. `surface` must be valid; keys that scrape or roll
/// sound like it.

/// Returns the LUFS of PhrasePrediction's phrase at its middle velocity, before `level`.
double predictedLufs(const std::shared_ptr<const Instrument>& instrument,
                     const Surface& surface,
                     double sampleRateHz,
                     const ParameterValues& values);

/// Returns the highest peak of the keys, struck one at a time at velocity 127; full scale is 1,
/// before `level`. Renders the first 50 ms of eight keys from the lowest to the highest.
double loudestStrikePeak(const std::shared_ptr<const Instrument>& instrument,
                         const Surface& surface,
                         double sampleRateHz,
                         const ParameterValues& parameters);

/// Returns the values, with another mallet of the rack if theirs leaves the instrument almost
/// silent, as yarn leaves a small ball of steel. The other mallet is the softest audible one, or
/// else the loudest.
ParameterValues withAudibleMallet(const std::shared_ptr<const Instrument>& instrument,
                                  const Surface& surface,
                                  double sampleRateHz,
                                  const ParameterValues& values);

/// Returns the `level` in dB at which about eight of the hardest strikes at once stay below full
/// scale (docs/decisions/0005); infinity if nothing sounds. Only for keys that strike.
double highestLevel(const std::shared_ptr<const Instrument>& instrument,
                    const Surface& surface,
                    double sampleRateHz,
                    const ParameterValues& values);

/// Returns the `level` in dB at which the instrument is as loud as the factory presets, but at most
/// `highestLevel`: short high sounds peak far above their loudness. Returns the values' own level
/// if nothing sounds. Only for keys that strike.
double startingLevel(const std::shared_ptr<const Instrument>& instrument,
                     const Surface& surface,
                     double sampleRateHz,
                     const ParameterValues& values);

} // namespace idiophone
