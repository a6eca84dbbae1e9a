// Measures the high frequencies of a signal, where a click shows.
#pragma once

#include "Support/Larger.h"
#include "Support/Phasor.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>

namespace idiophone::test {

/// [dB] Returns the largest power between 8 and 20 kHz in windows of a hundredth of a second.
inline double loudestHighsDb(std::span<const float> signal, double sampleRateHz) {
    constexpr std::size_t length = 512;
    double loudest = 0;
    for (std::size_t from = 0; from + length <= signal.size(); from += 64) {
        double power = 0;
        for (double hz = 8000; hz < 20000; hz += 250)
            power += std::norm(phasorAt(signal.subspan(from, length), hz, sampleRateHz));
        loudest = larger(loudest, power);
    }
    return 10 * std::log10(loudest);
}

} // namespace idiophone::test
