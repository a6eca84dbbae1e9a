// A true-peak limiter without latency: the last thing before the output, for safety and not for
// loudness.
#pragma once

#include "Output/PendingPeaks.h"

#include <array>
#include <cstddef>
#include <span>

namespace idiophone {

/// Sound whose true peak (ITU-R BS.1770-4) stays below `threshold` passes bit for bit. White noise
/// just below it may not: the next samples decide, and the limiter cannot wait for them. Louder
/// sound gets one gain for all channels, which falls within the sample and returns to exactly 1.
/// For the audio thread but for `prepare`, which is called while nothing processes; nothing
/// allocates, locks or throws. The samples do not depend on block sizes.
class Limiter {
public:
    static constexpr float threshold = 0.8912509f; ///< -1 dB of full scale
    static constexpr std::size_t mostChannels = 2;

    /// Switching the limiter on or off moves the gain over `rampSeconds`.
    void prepare(double sampleRateHz, double rampSeconds);

    /// The channels were silent, the gain is 1, and the next block switches without a ramp.
    void reset() noexcept;

    /// In place; at most `mostChannels` channels of `sampleCount` finite samples.
    void process(std::span<float* const> channels, std::size_t sampleCount, bool isOn) noexcept;

private:
    using Frame = std::array<float, mostChannels>;

    float nextGain(const Frame& frame, std::size_t channelCount) noexcept;
    bool passes(const Frame& frame, std::size_t channelCount) const noexcept;
    bool isWithinBounds(const Frame& frame, std::size_t channelCount, float atGain) const noexcept;
    float
    gainIfPredicted(const Frame& frame, std::size_t channelCount, float mostGain) const noexcept;
    void remember(const Frame& frame) noexcept;
    void catchUp() noexcept;

    std::array<PendingPeaks, mostChannels> pending;
    /// The last output samples, a ring: `pending` is made of them anew after quiet sound.
    std::array<Frame, PendingPeaks::taps> recent{};
    std::size_t recentPosition = 0;
    std::size_t quietSamples = 0; ///< in a row
    bool isPendingCurrent = false;
    float quietLevel = 0;
    float gain = 1;
    std::size_t holdSamples = 0, heldSamples = 0;
    float releasePerSample = 1;          ///< factor
    float share = 1, sharePerSample = 1; ///< of the gain reduction; 0: switched off
    bool startsAtTarget = true;
};

} // namespace idiophone
