#include "Output/Limiter.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace idiophone {
namespace {

// While the gain is 1, the predicted inter-sample peaks may reach -0.5 dB. The uncertainty of a
// meter's kernel and of the prediction is less than the difference to the threshold.
constexpr float predictedCeiling = 0.9440609f;
// While the gain is reduced, the pending values stay within these bounds. Samples up to the reserve
// may always follow, so the bounds can be met again at every sample. By induction, the whole output
// stays within -0.72 dB, and the gain never needs to be 0.
constexpr PendingPeaks::Bounds actingBounds{.ceiling = 0.9204496f, .reserve = 0.4f};
// The gain is held for half a period of 40 Hz, otherwise it would follow the waveform. It then
// returns by 120 dB/s: 50 ms after a reduction of 6 dB, 200 ms after 24 dB.
constexpr double holdSeconds = 0.0125, releaseDbPerSecond = 120;
constexpr float lowestHeldGain = 0.01f; // limits the silence after a single huge sample

} // namespace

void Limiter::prepare(double sampleRateHz, double rampSeconds) {
    holdSamples = static_cast<std::size_t>(holdSeconds * sampleRateHz);
    releasePerSample = static_cast<float>(std::pow(10, releaseDbPerSecond / 20 / sampleRateHz));
    sharePerSample = static_cast<float>(1 / std::max(1.0, rampSeconds * sampleRateHz));
    quietLevel = PendingPeaks::levelAlwaysBelow(predictedCeiling);
    reset();
}

void Limiter::reset() noexcept {
    recent.fill({});
    quietSamples = PendingPeaks::taps;
    isPendingCurrent = false;
    gain = 1;
    heldSamples = 0;
    startsAtTarget = true;
}

void Limiter::process(std::span<float* const> channels,
                      std::size_t sampleCount,
                      bool isOn) noexcept {
    if (startsAtTarget)
        share = isOn ? 1 : 0;
    startsAtTarget = false;
    const auto channelCount = std::min(channels.size(), maximumChannels);
    for (std::size_t i = 0; i < sampleCount; ++i) {
        Frame frame{};
        float highest = 0;
        for (std::size_t channel = 0; channel < channelCount; ++channel) {
            frame[channel] = channels[channel][i];
            highest = std::max(highest, std::abs(frame[channel]));
        }
        share =
            isOn ? std::min(share + sharePerSample, 1.0f) : std::max(share - sharePerSample, 0.0f);
        const bool isQuiet = highest <= quietLevel && quietSamples >= PendingPeaks::taps;
        if (share == 0) { // when switched on, the limiter starts from silence
            gain = 1;
            frame = {};
        } else if (gain < 1 || !isQuiet) {
            catchUp();
            gain = nextGain(frame);
            const float applied = share == 1 ? gain : 1 - share * (1 - gain);
            for (std::size_t channel = 0; channel < channelCount; ++channel) {
                channels[channel][i] = applied * frame[channel];
                frame[channel] *= gain;
            }
            highest *= gain;
        }
        quietSamples = highest <= quietLevel ? quietSamples + 1 : 0;
        remember(frame);
    }
}

/// Returns the gain that keeps all channels of the next frame within their limits.
float Limiter::nextGain(const Frame& frame) noexcept {
    if (gain == 1 && passes(frame))
        return 1;
    float maximumGain = gain;
    if (heldSamples > 0)
        --heldSamples;
    else
        maximumGain = std::min(std::max(gain, lowestHeldGain) * releasePerSample, 1.0f);
    if (isWithinBounds(frame, maximumGain))
        return maximumGain;
    float next = maximumGain, highest = 0;
    for (std::size_t channel = 0; channel < maximumChannels; ++channel) {
        next = pending[channel].maximumGainWithin(actingBounds, frame[channel], next);
        highest = std::max(highest, std::abs(frame[channel]));
    }
    // Sound that passed at gain 1 may have left values outside the bounds. Until they are inside,
    // the limiter relies on the prediction.
    if (!isWithinBounds(frame, next))
        next = gainIfPredicted(frame, maximumGain);
    next = std::max(next, std::min(maximumGain, actingBounds.reserve / highest));
    if (next < maximumGain)
        heldSamples = holdSamples;
    return next;
}

bool Limiter::passes(const Frame& frame) const noexcept {
    for (std::size_t channel = 0; channel < maximumChannels; ++channel) {
        const float next = frame[channel];
        if (std::abs(next) > threshold ||
            (pending[channel].highestBeforeSilence(next) > predictedCeiling &&
             pending[channel].highestIfPredicted(next) > predictedCeiling))
            return false;
    }
    return true;
}

bool Limiter::isWithinBounds(const Frame& frame, float atGain) const noexcept {
    constexpr float rounding = 1e-5f;
    for (std::size_t channel = 0; channel < maximumChannels; ++channel)
        if (!pending[channel].isWithin({actingBounds.ceiling + rounding, actingBounds.reserve},
                                       atGain * frame[channel]))
            return false;
    return true;
}

/// Returns the first of a few gains without an excessive predicted peak, or else the gain with the
/// lowest peak.
float Limiter::gainIfPredicted(const Frame& frame, float maximumGain) const noexcept {
    constexpr std::array shares{1.0f, 0.97f, 0.93f, 0.87f, 0.78f, 0.66f, 0.5f, 0.3f};
    float highest = threshold;
    for (std::size_t channel = 0; channel < maximumChannels; ++channel)
        highest = std::max(highest, maximumGain * std::abs(frame[channel]));
    const float allowedGain = maximumGain * threshold / highest;
    float best = 0, lowestPeak = std::numeric_limits<float>::infinity();
    for (const float tried : shares) {
        float peak = 0;
        for (std::size_t channel = 0; channel < maximumChannels; ++channel)
            peak = std::max(
                peak, pending[channel].highestIfPredicted(tried * allowedGain * frame[channel]));
        if (peak < lowestPeak) {
            lowestPeak = peak;
            best = tried * allowedGain;
        }
        if (peak <= predictedCeiling)
            break;
    }
    return best;
}

void Limiter::remember(const Frame& frame) noexcept {
    recent[recentPosition] = frame;
    recentPosition = (recentPosition + 1) % recent.size();
    if (gain == 1 && (share == 0 || quietSamples > PendingPeaks::taps)) {
        isPendingCurrent = false;
        return;
    }
    if (isPendingCurrent)
        for (std::size_t channel = 0; channel < maximumChannels; ++channel)
            pending[channel].push(frame[channel]);
}

/// Recomputes the pending values from the recent samples. The result is the same as if each sample
/// had been pushed in turn, because earlier samples contribute to no pending value.
void Limiter::catchUp() noexcept {
    if (isPendingCurrent)
        return;
    isPendingCurrent = true;
    for (std::size_t channel = 0; channel < maximumChannels; ++channel) {
        pending[channel].reset();
        for (std::size_t i = 0; i < recent.size(); ++i)
            pending[channel].push(recent[(recentPosition + i) % recent.size()][channel]);
    }
}

} // namespace idiophone
