// SPDX-License-Identifier: Apache-2.0
#include "Mesh/FaceSides.h"

#include <algorithm>

namespace idiophone {

std::vector<FaceSide> sortedFaceSides(const Mesh& mesh) {
    std::vector<FaceSide> sides;
    sides.reserve(static_cast<std::size_t>(mesh.faceCount()) * 3);
    for (int face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            const auto [low, high] =
                std::minmax({mesh.faces(face, corner), mesh.faces(face, (corner + 1) % 3)});
            sides.push_back({low, high, face, corner});
        }
    std::ranges::sort(sides);
    return sides;
}

} // namespace idiophone
