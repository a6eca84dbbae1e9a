// Chooses a mallet and level for an instrument that nobody has set by ear: audible, and as loud as
// the factory presets.
#pragma once

#include "Instrument/Phrase.h"
#include "Parameters/ParameterTable.h"

namespace idiophone {

/// None of these is for the audio thread.

/// Returns the highest peak of the keys, struck one at a time at velocity 127; full scale is 1,
/// before `level`. Renders the first 50 ms of eight keys from the lowest to the highest.
double loudestStrikePeak(const Phrase& phrase, const ParameterValues& parameters);

/// Returns the values, with another mallet of the rack if theirs leaves the instrument almost
/// silent, as yarn does a small ball of steel. It is the softest audible mallet, or else the
/// loudest.
ParameterValues withAudibleMallet(const Phrase& phrase, const ParameterValues& values);

/// Returns the `level` in dB at which about eight of the hardest strikes at once stay below full
/// scale (docs/decisions/0005); infinity if nothing sounds. For keys that strike.
double highestLevel(const Phrase& phrase, const ParameterValues& values);

/// Returns the `level` in dB at which the instrument is as loud as the factory presets, but at most
/// `highestLevel`: short high sounds peak far above their loudness. Returns the values' own level
/// if nothing sounds. For keys that strike.
double startingLevel(const Phrase& phrase, const ParameterValues& values);

} // namespace idiophone
