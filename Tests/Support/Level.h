// Measures how loud a signal is, for tests: its root mean square and its peak.
#pragma once

#include "Support/Larger.h"

#include <cmath>
#include <span>

namespace idiophone::test {

/// `signal` has at least one sample.
inline double rms(std::span<const float> signal) {
    double sum = 0;
    for (const float sample : signal)
        sum += static_cast<double>(sample) * sample;
    return std::sqrt(sum / static_cast<double>(signal.size()));
}

inline float peak(std::span<const float> signal) {
    float highest = 0;
    for (const float sample : signal)
        highest = larger(highest, std::abs(sample));
    return highest;
}

} // namespace idiophone::test
