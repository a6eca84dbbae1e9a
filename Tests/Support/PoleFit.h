// Fits one decaying sinusoid near a frequency: a pole, not an FFT bin.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <span>

namespace idiophone::test {

struct FittedPole {
    double frequencyHz = 0;
    double decayPerSecond = 0;
};

/// Heterodynes at the expected frequency, averages under Hann windows, and takes the least-squares
/// ratio of successive frames. Repeats this until the frequency converges. `frameSeconds` must be
/// long compared with 1 / (distance to the next partial in Hz).
inline FittedPole fitPole(std::span<const float> signal,
                          double sampleRateHz,
                          double expectedHz,
                          double frameSeconds) {
    const auto frame = static_cast<std::size_t>(frameSeconds * sampleRateHz);
    const std::size_t hop = frame / 8;
    const double turn = 2 * std::numbers::pi / static_cast<double>(frame);
    const double hopSeconds = static_cast<double>(hop) / sampleRateHz;
    FittedPole pole{.frequencyHz = expectedHz, .decayPerSecond = 0};
    for (int round = 0; round < 4; ++round) {
        const double omega = 2 * std::numbers::pi * pole.frequencyHz / sampleRateHz;
        std::complex<double> previous = 0;
        std::complex<double> product = 0;
        double energy = 0;
        for (std::size_t start = 0; start + frame <= signal.size(); start += hop) {
            std::complex<double> sum = 0;
            for (std::size_t i = 0; i < frame; ++i) {
                const double hann = 1 - std::cos(turn * static_cast<double>(i));
                sum += hann * signal[start + i] *
                       std::polar(1.0, -omega * static_cast<double>(start + i));
            }
            if (start > 0) {
                product += sum * std::conj(previous);
                energy += std::norm(previous);
            }
            previous = sum;
        }
        const auto step = std::log(product / energy) / hopSeconds;
        pole.frequencyHz += step.imag() / (2 * std::numbers::pi);
        pole.decayPerSecond = -step.real();
    }
    return pole;
}

inline double cents(double frequencyHz, double referenceHz) {
    return 1200 * std::log2(frequencyHz / referenceHz);
}

} // namespace idiophone::test
