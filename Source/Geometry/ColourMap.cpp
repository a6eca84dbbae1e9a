#include "Geometry/ColourMap.h"

#include <algorithm>
#include <cmath>
#include <igl/colormap.h>

namespace idiophone {

std::array<std::uint8_t, 3> viridis(double share) {
    const double place = share > 0 ? std::min(share, 1.0) : 0; // also for NaN
    std::array<double, 3> parts{};
    igl::colormap(igl::COLOR_MAP_TYPE_VIRIDIS, place, parts[0], parts[1], parts[2]);
    std::array<std::uint8_t, 3> colour{};
    std::ranges::transform(parts, colour.begin(), [](double part) {
        return static_cast<std::uint8_t>(std::lround(255 * part));
    });
    return colour;
}

} // namespace idiophone
