// SPDX-License-Identifier: Apache-2.0
// Checks that input values are finite or bounded, without a branch per value.
#pragma once

#include <bit>
#include <cstdint>
#include <span>

namespace idiophone {

inline bool allFinite(std::span<const float> values) noexcept {
    constexpr std::uint32_t exponent = 0x7f800000u;
    bool finite = true;
    for (const float value : values)
        finite &= (std::bit_cast<std::uint32_t>(value) & exponent) != exponent;
    return finite;
}

/// Returns whether each value is a number between −limit and limit (≥ 0).
inline bool allWithin(std::span<const float> values, float limit) noexcept {
    // The bits of magnitudes, read as integers, sort like the magnitudes; NaN sorts last.
    const auto limitBits = std::bit_cast<std::int32_t>(limit);
    std::int32_t room = 0; // negative if a value exceeds the limit
    for (const float value : values)
        room |= limitBits - (std::bit_cast<std::int32_t>(value) & 0x7fffffff);
    return room >= 0;
}

} // namespace idiophone
