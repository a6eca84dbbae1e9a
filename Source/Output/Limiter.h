// A true-peak limiter without latency: the last step before the output, for safety and not for
// loudness.
#pragma once

#include "Output/PendingPeaks.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// Sound whose true peak (ITU-R BS.1770-4) stays below `threshold` passes bit for bit. White noise
/// just below the threshold may change, because later samples decide about its peaks. Louder sound
/// gets one gain for all channels. The gain falls within the sample and returns to exactly 1. Call
/// `prepare` while nothing processes. The other functions are for the audio thread; none allocates,
/// locks or throws. The samples do not depend on block sizes.
class Limiter {
public:
    static constexpr float threshold = 0.8912509f; ///< -1 dB of full scale
    static constexpr std::size_t maximumChannels = 2;

    /// `rampSeconds`: the time in which the limiter is switched on or off.
    void prepare(double sampleRateHz, double rampSeconds);

    /// Restores silent channels and a gain of 1. The next block switches without a ramp.
    void reset() noexcept;

    /// Processes in place: at most `maximumChannels` channels of `sampleCount` finite samples.
    void process(std::span<float* const> channels, std::size_t sampleCount, bool isOn) noexcept;

private:
    using Frame = std::array<float, maximumChannels>;

    float nextGain(const Frame& frame) noexcept;
    bool passes(const Frame& frame) const noexcept;
    bool isWithinBounds(const Frame& frame, float atGain) const noexcept;
    float gainIfPredicted(const Frame& frame, float maximumGain) const noexcept;
    void remember(const Frame& frame) noexcept;
    void catchUp() noexcept;

    std::array<PendingPeaks, maximumChannels> pending;
    /// Ring of the last output samples, to recompute `pending` after quiet sound.
    std::array<Frame, PendingPeaks::taps> recent{};
    std::size_t recentPosition = 0;
    std::size_t quietSamples = 0; ///< consecutive quiet samples
    bool isPendingCurrent = false;
    float quietLevel = 0;
    float gain = 1;
    std::size_t holdSamples = 0, heldSamples = 0;
    float releasePerSample = 1;          ///< factor of the gain
    float share = 1, sharePerSample = 1; ///< share of the reduction in effect; 0: off
    bool startsAtTarget = true;
};

} // namespace idiophone
