// The gain that a loudness match arrives at.
#pragma once

#include "Instrument/LoudnessMatch.h"

namespace idiophone::test {

/// Of these values as they would be struck.
inline double gainOf(LoudnessMatch& match, ParameterValues now) {
    now.set(ParameterId::matchLoudness, 1);
    match.prepare(now);
    return match.gainDb();
}

} // namespace idiophone::test
