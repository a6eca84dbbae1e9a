#include "Geometry/ColourMap.h"

#include <algorithm>
#include <cmath>
#include <cstddef>

namespace idiophone {

std::array<std::uint8_t, 3> viridis(double share) {
    constexpr std::array<std::array<int, 3>, 17> places{{
        {68, 1, 84},
        {72, 24, 106},
        {71, 45, 123},
        {66, 64, 134},
        {59, 82, 139},
        {51, 99, 141},
        {44, 114, 142},
        {38, 130, 142},
        {33, 145, 140},
        {31, 159, 136},
        {39, 173, 129},
        {61, 188, 116},
        {92, 200, 99},
        {129, 211, 77},
        {170, 220, 50},
        {213, 226, 26},
        {253, 231, 37},
    }};
    constexpr auto last = static_cast<double>(places.size() - 1);
    const double place = share > 0 ? std::min(share, 1.0) * last : 0; // also for NaN
    const auto below = std::min(static_cast<std::size_t>(place), places.size() - 2);
    const double way = place - static_cast<double>(below);
    std::array<std::uint8_t, 3> colour{};
    for (std::size_t part = 0; part < colour.size(); ++part)
        colour[part] = static_cast<std::uint8_t>(
            std::lround((1 - way) * places[below][part] + way * places[below + 1][part]));
    return colour;
}

} // namespace idiophone
