#include "Geometry/SpreadVertices.h"

namespace idiophone {

std::vector<int>
spreadVertices(const Mesh& mesh, const std::vector<int>& candidates, std::size_t count) {
    const auto squaredDistance = [&](std::size_t i, std::size_t j) {
        return (mesh.vertices.row(candidates[i]) - mesh.vertices.row(candidates[j])).squaredNorm();
    };
    std::vector<int> chosen;
    for (const auto place : spreadPlaces<double>(candidates.size(), count, squaredDistance))
        chosen.push_back(candidates[place]);
    std::ranges::sort(chosen);
    return chosen;
}

} // namespace idiophone
