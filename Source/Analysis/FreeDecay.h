// Finds the part of a recording in which a struck object rings freely: after the strongest strike's
// contact, until the next strike or the end. RecordingFit finds its modes.
#pragma once

#include "Object/Result.h"

#include <cstddef>
#include <span>

namespace idiophone {

inline constexpr double shortestDecaySeconds = 0.02;

/// Sample indices. The contact lasts from `onset` to `begin`, and the free decay from `begin` to
/// `end`.
struct FreeDecay {
    std::size_t onset = 0;
    std::size_t begin = 0;
    std::size_t end = 0;
    bool clipped = false; ///< the strike exceeds full scale
    bool others = false;  ///< the recording also has other strikes
};

/// Finds the strike with the highest peak. If the contact's length is unknown (`contactSeconds` 0),
/// it is taken as twice the time in which the sound rises to half its height, 0.2 to 8 ms.
///
/// An error continues a sentence that starts with the recording's name: "it is silent".
Result<FreeDecay>
findFreeDecay(std::span<const float> samples, double sampleRateHz, double contactSeconds = 0);

} // namespace idiophone
