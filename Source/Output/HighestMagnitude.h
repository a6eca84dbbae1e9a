// The highest magnitude of samples, as a loop that compilers vectorise.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <span>

namespace idiophone {

/// Returns 0 for no samples, NaN if one of them is NaN. Magnitudes compare like their bits.
inline float highestMagnitude(std::span<const float> samples) noexcept {
    std::int32_t highest = 0;
    for (const float sample : samples)
        highest = std::max(highest, std::bit_cast<std::int32_t>(sample) & 0x7fffffff);
    return std::bit_cast<float>(highest);
}

} // namespace idiophone
