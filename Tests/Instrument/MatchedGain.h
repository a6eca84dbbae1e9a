// The complete gain of a loudness match.
#pragma once

#include "Instrument/LoudnessMatch.h"

namespace idiophone::test {

/// Returns the gain in dB for these values with "match loudness" on.
inline double gainOf(LoudnessMatch& match, ParameterValues now) {
    now.set(ParameterId::matchLoudness, 1);
    match.prepare(now);
    return match.gainDb();
}

} // namespace idiophone::test
