// From a key's velocity and the mallet's parameters to a contact: where, how hard, how long.
#pragma once

#include "Parameters/ParameterTable.h"
#include "Synth/Strike.h"

#include <cstdint>

namespace idiophone {

struct StrikePlace {
    double along = 0;  ///< 0 to 1 on the strip
    double across = 0; ///< −1 to 1
};

/// The place of a strike: the key's own, moved by "strike position" and strayed by "spread". The
/// same `strikeNumber` always strays the same way, so that a render repeats. Any thread.
StrikePlace
strikePlace(double keyAlong, const ParameterValues& parameters, std::uint32_t strikeNumber);

/// The strike of a mallet at MIDI velocity 1 to 127: impulse m v, contact time after Hertz,
/// T = 2.87 (m² / (R E*² v))^(1/5) with a head of radius 12.5 mm. A mallet scaled by s has s³ its
/// mass and s times its contact time at the same speed. Any thread.
Strike malletStrike(const StrikePoint& point,
                    int velocity,
                    double malletScale,
                    const ParameterValues& parameters);

} // namespace idiophone
