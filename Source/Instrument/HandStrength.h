// How hard a hand has to scrape to be heard beside blows.
#pragma once

#include "Instrument/LoudnessMatch.h"
#include "Parameters/ParameterTable.h"

namespace idiophone {

/// What multiplies the contact force of a hand: a scrape of some newtons is 40 to 60 dB weaker than
/// a blow of a mallet, and presets that strike have their level by blows. With it a drag of half a
/// metre a second is about as loud as blows, by the prediction for the preset's own values. 1 where
/// its keys scrape or roll, and where nothing sounds. Not for the audio thread.
double handStrength(const LoudnessMatch& loudness, const ParameterValues& own);

} // namespace idiophone
