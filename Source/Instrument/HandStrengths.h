// How hard a hand has to scrape to be heard beside blows.
#pragma once

#include "Instrument/Instrument.h"
#include "Parameters/ParameterTable.h"
#include "Synth/Surface.h"

#include <memory>
#include <vector>

namespace idiophone {

/// [slots] What multiplies the contact force of a hand on each object: a scrape of some newtons is
/// 37 to 75 dB weaker than a blow of a mallet, and presets that strike have their level by blows.
/// With it a drag of half a metre a second is nearly as loud as a blow there, by the prediction for
/// the preset's own values; what is changed afterwards is heard. 1 where keys scrape or roll
/// themselves, and where nothing sounds. The surface is valid. Not for the audio thread.
std::vector<double> handStrengths(const std::shared_ptr<const Instrument>& instrument,
                                  const Surface& surface,
                                  double sampleRateHz,
                                  const ParameterValues& own);

} // namespace idiophone
