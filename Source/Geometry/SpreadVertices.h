// Selects a few positions out of many, spread as evenly as possible.
#pragma once

#include "Mesh/Mesh.h"

#include <algorithm>
#include <cstddef>
#include <limits>
#include <vector>

namespace idiophone {

/// Selects `count` of the positions 0 … places − 1: the first, then always the one farthest from
/// those selected (Gonzalez 1985). Returns them in ascending order, or fewer if there are not
/// enough distinct ones. `squaredDistance(i, j)` returns a Scalar.
template <class Scalar, class SquaredDistance>
std::vector<std::size_t>
spreadPlaces(std::size_t places, std::size_t count, const SquaredDistance& squaredDistance) {
    // Prefer earlier positions slightly, so that rounding does not choose among equals.
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

/// Selects `count` of the candidate vertices in the same way; ascending.
std::vector<int>
spreadVertices(const Mesh& mesh, const std::vector<int>& candidates, std::size_t count);

} // namespace idiophone
