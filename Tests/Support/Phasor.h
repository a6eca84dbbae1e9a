// One frequency of a short signal, for tests that ask for a few lines of a spectrum only.
#pragma once

#include <cmath>
#include <complex>
#include <numbers>
#include <span>

namespace idiophone::test {

/// The Fourier sum at any one frequency under a Hann window of mean 1: a sinusoid of amplitude a
/// gives half of a times the number of samples, turned by its phase at the first.
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
