// Computes single lines of the spectrum of a short signal, for tests.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <span>

namespace idiophone::test {

/// Returns the Fourier sum at any frequency under a Hann window of mean 1. A sinusoid of amplitude
/// a gives a/2 times the number of samples, with its phase at the first sample.
inline std::complex<double>
phasorAt(std::span<const float> signal, double frequencyHz, double sampleRateHz) {
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < signal.size(); ++k) {
        const double turn = 2 * std::numbers::pi * static_cast<double>(k);
        sum += (1 - std::cos(turn / static_cast<double>(signal.size()))) *
               static_cast<double>(signal[k]) * std::polar(1.0, -turn * frequencyHz / sampleRateHz);
    }
    return sum;
}

} // namespace idiophone::test
