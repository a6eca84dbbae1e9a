// Colours for figures on a surface: the perceptually uniform map "viridis".
#pragma once

#include <array>
#include <cstdint>

namespace idiophone {

/// Dark violet at 0 over green to yellow at 1, equal steps looking equally far; what is beyond gets
/// the colour of that end, and what is no number that of 0. Viridis, by Nathaniel Smith and Stefan
/// van der Walt (2015, CC0), from libigl.
std::array<std::uint8_t, 3> viridis(double share);

} // namespace idiophone
