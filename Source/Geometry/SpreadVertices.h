// A few places out of many, spread as evenly as can be.
#pragma once

#include "Geometry/Mesh.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace idiophone {

/// `count` of the places 0 … places − 1, each the farthest from those before (Gonzalez 1985),
/// beginning with the first; ascending. Fewer where there are not as many apart.
/// `squaredDistance(i, j)` is a Scalar.
template <class Scalar, class SquaredDistance>
std::vector<std::size_t>
spreadPlaces(std::size_t places, std::size_t count, const SquaredDistance& squaredDistance) {
    // A hair of preference for the earlier keeps rounding from choosing among equals.
    constexpr auto hair = static_cast<Scalar>(1 + 1e-9);
    std::vector<std::size_t> chosen;
    std::vector<Scalar> nearest(places, std::numeric_limits<Scalar>::infinity());
    while (chosen.size() < std::min(count, places)) {
        std::size_t next = 0;
        for (std::size_t i = 1; i < places; ++i)
            if (nearest[i] > nearest[next] * hair)
                next = i;
        if (!(nearest[next] > 0))
            break;
        chosen.push_back(next);
        for (std::size_t i = 0; i < places; ++i)
            nearest[i] = std::min(nearest[i], squaredDistance(i, next));
    }
    std::ranges::sort(chosen);
    return chosen;
}

/// `count` of these vertices, spread so; ascending.
std::vector<int>
spreadVertices(const Mesh& mesh, const std::vector<int>& candidates, std::size_t count);

} // namespace idiophone
