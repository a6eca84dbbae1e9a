// Mixes the sound that went into an effect with the one that comes out of it.
#pragma once

#include "Output/Ramp.h"
#include "Parameters/ParameterTable.h"

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

namespace idiophone {

/// Call `prepare` while nothing processes. The other functions are for the audio thread and do not
/// allocate, lock or throw. At constant parameters the samples do not depend on block sizes.
class DryWet {
public:
    void prepare(double sampleRateHz, double rampSeconds) {
        wet.prepare(sampleRateHz, rampSeconds);
        reset();
    }
    /// The next block starts at its parameter values without a ramp.
    void reset() noexcept { startsAtTarget = true; }

    /// Mixes `dry` into the channels, which have as many samples. In bypass only the dry sound
    /// remains. A missing second dry channel is the first.
    void process(std::span<const std::span<const float>> dry,
                 std::span<float* const> channels,
                 const ParameterValues& values) noexcept {
        if (dry.empty())
            return;
        const bool isBypassed = values[ParameterId::bypass] != 0;
        wet.moveTo(isBypassed ? 0.0f : static_cast<float>(values[ParameterId::dryWet] / 100));
        if (std::exchange(startsAtTarget, false))
            wet.jumpToTarget();
        for (std::size_t k = 0; k < dry.front().size(); ++k) {
            const float share = wet.next();
            for (std::size_t c = 0; c < channels.size(); ++c)
                channels[c][k] =
                    share * channels[c][k] + (1 - share) * dry[std::min(c, dry.size() - 1)][k];
        }
    }

private:
    Ramp<> wet; ///< the share of the effect's sound
    bool startsAtTarget = true;
};

} // namespace idiophone
