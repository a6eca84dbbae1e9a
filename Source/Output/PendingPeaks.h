// The inter-sample values of one channel that its newest samples have begun to decide: what a
// true-peak meter will find between the samples, as far as it is known.
#pragma once

#include <array>
#include <cstddef>

namespace idiophone {

/// Interpolates by four with a Kaiser-windowed sinc of 16 taps, close to the 12 taps of ITU-R
/// BS.1770-4, Annex 2. A value is pending while samples to come contribute to it. All functions but
/// `levelAlwaysBelow` are for the audio thread and neither allocate, lock nor throw.
class PendingPeaks {
public:
    static constexpr std::size_t taps = 16, phases = 4, count = taps * phases;

    PendingPeaks();
    void reset() noexcept;

    /// Appends a sample to the channel.
    void push(float sample) noexcept;

    /// The largest magnitude among the pending values after `next`, if silence follows.
    float highestBeforeSilence(float next) const noexcept;

    /// The same if the sound goes on as its last samples predict: the lower value of two
    /// predictions. One is the least-squares prediction (Makhoul 1975, Proc. IEEE 63, 561) of noise
    /// whose spectrum falls above a quarter of the sample rate. The other continues the sine that
    /// fits the samples best.
    float highestIfPredicted(float next) const noexcept;

    /// Limits of the pending values. Samples to come contribute to a value with the share r, the
    /// sum of their magnitudes in the kernel. The value may reach `ceiling` - r `reserve`, so that
    /// samples up to `reserve` can always follow.
    struct Bounds {
        float ceiling, reserve;
    };

    /// Every pending value is within the bounds after `next`.
    bool isWithin(const Bounds& bounds, float next) const noexcept;

    /// The largest gain of `next` in [0, `mostGain`] at which no value that it raises leaves the
    /// bounds.
    float mostGainWithin(const Bounds& bounds, float next, float mostGain) const noexcept;

    /// While the last `taps` samples stay at or below this magnitude, every pending value stays at
    /// or below `ceiling`.
    static float levelAlwaysBelow(float ceiling);

private:
    static constexpr std::size_t remembered = 8; ///< samples that predict the next ones
    using Future = std::array<float, taps / 2>;
    struct Tables;
    static const Tables& sharedTables();

    float highestBefore(float next, const Future& future) const noexcept;
    Future noisePrediction(float next) const noexcept;
    Future sinePrediction(float next) const noexcept;

    const Tables& tables;
    std::array<float, count> values{}; ///< by time, from the earliest interval that is pending
    std::array<float, remembered> samples{}; ///< newest first
};

} // namespace idiophone
