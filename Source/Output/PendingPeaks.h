// The inter-sample values of one channel that depend on its newest samples and on samples to come.
// From these values the limiter predicts the peaks of a true-peak meter.
#pragma once

#include <array>
#include <cstddef>

namespace idiophone {

/// Interpolates by four with a Kaiser-windowed sinc of 16 taps, close to the 12 taps of ITU-R
/// BS.1770-4, Annex 2. A value is pending while samples to come contribute to it. All functions
/// except `levelAlwaysBelow` are for the audio thread and do not allocate, lock or throw.
class PendingPeaks {
public:
    static constexpr std::size_t taps = 16, phases = 4, count = taps * phases;

    PendingPeaks();
    void reset() noexcept;

    void push(float sample) noexcept;

    /// Returns the maximum magnitude of the pending values after `next`, if silence follows.
    float highestBeforeSilence(float next) const noexcept;

    /// Returns the same maximum for a predicted continuation: the lower one of two predictions. One
    /// is the least-squares prediction (Makhoul 1975, Proc. IEEE 63, 561) of noise whose spectrum
    /// falls above a quarter of the sample rate. The other continues the sine that fits the samples
    /// best.
    float highestIfPredicted(float next) const noexcept;

    /// Limits of the pending values. Let r be the sum of the kernel's magnitudes over the samples
    /// to come. The value may reach `ceiling` - r `reserve`, so that samples up to `reserve` can
    /// always follow.
    struct Bounds {
        float ceiling, reserve;
    };

    /// Returns whether every pending value is within the bounds after `next`.
    bool isWithin(const Bounds& bounds, float next) const noexcept;

    /// Returns the maximum gain of `next` in [0, `maximumGain`] at which no value that it raises
    /// exceeds the bounds.
    float maximumGainWithin(const Bounds& bounds, float next, float maximumGain) const noexcept;

    /// Returns a magnitude: if the last `taps` samples do not exceed it, no pending value exceeds
    /// `ceiling`.
    static float levelAlwaysBelow(float ceiling);

private:
    static constexpr std::size_t remembered = 8; ///< samples used for prediction
    using Future = std::array<float, taps / 2>;
    struct Tables;
    static const Tables& sharedTables();

    float highestBefore(float next, const Future& future) const noexcept;
    Future noisePrediction(float next) const noexcept;
    Future sinePrediction(float next) const noexcept;

    const Tables& tables;
    std::array<float, count> values{};       ///< by time, from the earliest pending interval
    std::array<float, remembered> samples{}; ///< newest first
};

} // namespace idiophone
