// Colours for values on a surface: the perceptually uniform map "viridis".
#pragma once

#include <array>
#include <cstdint>

namespace idiophone {

/// Returns dark violet at 0, green between and yellow at 1; equal steps look equally large. Values
/// outside [0, 1] are clamped; NaN counts as 0. Viridis by Nathaniel Smith and Stefan van der Walt
/// (2015, CC0), from libigl.
std::array<std::uint8_t, 3> viridis(double share);

} // namespace idiophone
