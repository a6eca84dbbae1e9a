// Whether figures from outside are numbers, without a branch for each.
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

} // namespace idiophone
