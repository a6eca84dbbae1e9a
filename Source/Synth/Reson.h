// SPDX-License-Identifier: Apache-2.0
// A resonance as one complex pole, z[n] = p z[n−1] + x[n]. Each step shrinks |z| by |p| before it
// adds the input, so the pole may move at every sample without a burst. The two real coefficients
// of a direct form do not guarantee this.
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

/// p = e^{(−d + 2πi f) / sample rate}; |p| < 1.
struct ResonPole {
    double real = 0;
    double imaginary = 0;

    /// Frequencies are limited to 0.45 of the sample rate.
    static ResonPole at(double frequencyHz, double dampingPerSecond, double sampleRateHz) noexcept {
        const double angle =
            2 * std::numbers::pi * std::min(frequencyHz / sampleRateHz, highestFrequency);
        const double radius = std::exp(-dampingPerSecond / sampleRateHz);
        return {radius * std::cos(angle), radius * std::sin(angle)};
    }

    /// Returns the pole of a Butterworth low-pass of order 2; the −3 dB frequency must be far below
    /// the sample rate.
    static ResonPole lowPass(double cutoffHz, double sampleRateHz) noexcept {
        const double equalParts = cutoffHz / std::numbers::sqrt2;
        return at(equalParts, 2 * std::numbers::pi * equalParts, sampleRateHz);
    }

    /// Returns the input gain for which Im z equals a constant input. The transfer function
    /// is then that of the resonance (d² + ω²)/((s + d)² + ω²).
    double unitGainAtZero() const noexcept {
        return ((1 - real) * (1 - real) + imaginary * imaginary) / imaginary;
    }

    /// Returns |Im z / x|² at the angle per sample with this cosine, for an input gain of 1.
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
