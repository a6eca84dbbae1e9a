// The gain of a player that matches loudness, and its way from the thread that predicts it.
#pragma once

#include "Instrument/LatestValue.h"
#include "Instrument/LoudnessMatch.h"

#include <optional>
#include <utility>

namespace idiophone {

/// Belongs to one player, so no answer reaches another one. Constructed and destroyed off the audio
/// thread.
class MatchedGain {
public:
    explicit MatchedGain(LoudnessMatch loudnessMatch) : match(std::move(loudnessMatch)) {}

    /// [audio thread] Returns the gain in dB for these values and a modulation wheel at 0 to 127.
    /// Predicts an unknown gain at once if `mayPredict`: offline, or before the first cell.
    /// Otherwise returns the last gain until the values change to a known gain or `answer` has
    /// found the new one. Neither allocates, locks nor throws.
    double follow(const ParameterValues& values, int wheel, bool mayPredict) noexcept;

    /// [one thread at a time, not the audio thread] Predicts the gain that `follow` lacks, if any.
    void answer() noexcept;

private:
    struct Known {
        LoudnessMatch::Goal goal;
        double gainDb = 0;
    };

    void find(bool mayPredict) noexcept;

    const LoudnessMatch match;
    LatestValue<LoudnessMatch::Goal> wanted{{}}; ///< from the audio thread
    LatestValue<Known> answers{{}};              ///< to the audio thread

    // Members of the audio thread.
    ParameterValues seenValues;
    int seenWheel = -1;
    std::optional<LoudnessMatch::Goal> goal;
    bool isPosted = false; ///< whether `wanted` has the goal
    Known known;
    double gainDb = 0; ///< in effect
};

} // namespace idiophone
