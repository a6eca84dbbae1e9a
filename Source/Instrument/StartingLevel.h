// How an instrument that nobody has set by ear starts: with a mallet that makes it sound, as loud
// as the factory presets.
#pragma once

#include "Instrument/Instrument.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <memory>

namespace idiophone {

/// Not for the audio thread, as all of these. The surface, which is valid, is what keys that scrape
/// or roll sound like.

/// LUFS of the phrase of PhrasePrediction at its middle velocity, before `level`.
double predictedLufs(const std::shared_ptr<const Instrument>& instrument,
                     const Surface& surface,
                     double sampleRateHz,
                     const ParameterValues& values);

/// The values, but with a mallet of the rack where theirs leaves the instrument all but silent, as
/// yarn does a small ball of steel: the softest that makes it sound, or the one that does it best.
ParameterValues withAudibleMallet(const std::shared_ptr<const Instrument>& instrument,
                                  const Surface& surface,
                                  double sampleRateHz,
                                  const ParameterValues& values);

/// In dB, the `level` at which about eight of the hardest blows at once stay below full scale
/// (docs/decisions/0005); infinity where nothing sounds. For keys that strike.
double highestLevel(const std::shared_ptr<const Instrument>& instrument,
                    const Surface& surface,
                    double sampleRateHz,
                    const ParameterValues& values);

/// In dB: as loud as the factory presets, but no higher than `highestLevel`: what rings short and
/// high peaks far above its loudness. That of the values where nothing sounds. For keys that
/// strike.
double startingLevel(const std::shared_ptr<const Instrument>& instrument,
                     const Surface& surface,
                     double sampleRateHz,
                     const ParameterValues& values);

} // namespace idiophone
