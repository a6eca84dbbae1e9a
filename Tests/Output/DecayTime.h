// Measures the decay time of a room's response.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace idiophone::test {

/// Returns T60 in seconds from Schroeder's backward integral, between −5 and −`lowestDb` dB.
inline double decaySecondsOf(const std::vector<double>& samples, double rateHz, double lowestDb) {
    std::vector<double> left(samples.size());
    double sum = 0;
    for (std::size_t i = samples.size(); i-- > 0;)
        left[i] = sum += samples[i] * samples[i];
    const auto fallen = [&](double decibels) {
        const double wanted = left.front() * std::pow(10, -decibels / 10);
        return std::ranges::find_if(left, [&](double x) { return x < wanted; }) - left.begin();
    };
    return static_cast<double>(fallen(lowestDb) - fallen(5)) / rateHz * 60 / (lowestDb - 5);
}

} // namespace idiophone::test
