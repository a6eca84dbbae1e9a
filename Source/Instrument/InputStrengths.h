// How hard sound that comes in presses on each key's object.
#pragma once

#include "Instrument/Phrase.h"
#include "Parameters/ParameterTable.h"

#include <array>

namespace idiophone {

/// Returns the newtons [notes] of full scale at which white noise comes out as loud as it goes in
/// (ITU-R BS.1770, mean of the channels, after `level`), as predicted for the preset's own values;
/// later changes of values stay audible. 0 for all if nothing sounds. Eight keys are predicted (in
/// a kit all), and the others lie between them. Each sample acts as an impulse. Not for the audio
/// thread.
std::array<double, 128> inputStrengths(const Phrase& phrase, const ParameterValues& own);

} // namespace idiophone
