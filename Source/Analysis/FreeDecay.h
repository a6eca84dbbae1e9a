// Where in a recording a struck object rings freely: after the strongest strike's contact, until
// the next strike or the end. What it rings with is RecordingFit's.
#pragma once

#include "Object/Result.h"

#include <cstddef>
#include <span>

namespace idiophone {

inline constexpr double shortestDecaySeconds = 0.02;

/// Sample numbers: the contact lasts from `onset` to `begin`, the free decay from `begin` to `end`.
struct FreeDecay {
    std::size_t onset = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    bool clipped = false; ///< the strike went over full scale
    bool others = false;  ///< the recording holds other strikes, too
};

/// Finds the strike of the greatest peak. A contact of unknown length (`contactSeconds` 0) is taken
/// to last twice as long as the sound rises, 0.2 to 8 ms.
///
/// The error is what the recording lacks, to be put after its name: "it is silent".
Result<FreeDecay>
findFreeDecay(std::span<const float> samples, double sampleRateHz, double contactSeconds = 0);

} // namespace idiophone
