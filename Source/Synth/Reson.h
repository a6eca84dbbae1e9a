// A resonance as one complex pole, z[n] = p z[n−1] + x[n]. Each step shrinks |z| by |p| before it
// adds the input, so the pole may move at every sample without a burst (two real coefficients of a
// direct form promise no such thing).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

/// p = e^{(−d + 2πi f) / sample rate}; |p| < 1.
struct ResonPole {
    double real = 0;
    double imaginary = 0;

    /// Frequencies above 0.45 of the sample rate count as that.
    static ResonPole at(double frequencyHz, double dampingPerSecond, double sampleRateHz) noexcept {
        const double angle =
            2 * std::numbers::pi * std::min(frequencyHz / sampleRateHz, highestFrequency);
        const double radius = std::exp(-dampingPerSecond / sampleRateHz);
        return {radius * std::cos(angle), radius * std::sin(angle)};
    }

    /// The poles of a Butterworth low-pass of order 2, where −3 dB lies far below the sample rate.
    static ResonPole lowPass(double cutoffHz, double sampleRateHz) noexcept {
        const double equalParts = cutoffHz / std::numbers::sqrt2;
        return at(equalParts, 2 * std::numbers::pi * equalParts, sampleRateHz);
    }

    /// What the input is multiplied by so that Im z answers a constant with itself: the transfer
    /// function is then that of the resonance (d² + ω²)/((s + d)² + ω²).
    double unitGainAtZero() const noexcept {
        return ((1 - real) * (1 - real) + imaginary * imaginary) / imaginary;
    }

    /// |Im z / x|² at an angle per sample whose cosine is given, for an input of gain 1.
    double power(double cosine) const noexcept {
        const double a1 = -2 * real, a2 = real * real + imaginary * imaginary;
        return imaginary * imaginary /
               (1 + a1 * a1 + a2 * a2 + 2 * a1 * (1 + a2) * cosine +
                2 * a2 * (2 * cosine * cosine - 1));
    }

    static constexpr double highestFrequency = 0.45;
};

struct Reson {
    double real = 0;
    double imaginary = 0;

    void step(const ResonPole& pole, double input) noexcept {
        const double before = real;
        real = pole.real * before - pole.imaginary * imaginary + input;
        imaginary = pole.real * imaginary + pole.imaginary * before;
    }
};

} // namespace idiophone
