#include "Sampling/ObjectPlaces.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>

namespace idiophone {
namespace {

double distance(const std::array<double, 3>& a, const std::array<double, 3>& b) {
    return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

} // namespace

std::array<double, 3> vertexOfRow(const ModalObject& object, std::size_t row) {
    const auto* place = &object.vertices[3 * static_cast<std::size_t>(object.shapeVertices[row])];
    return {place[0], place[1], place[2]};
}

Result<std::vector<std::size_t>> spreadPlaces(const ModalObject& object, std::size_t count) {
    const auto candidates = object.shapeVertexCount();
    if (count > candidates)
        return failure("it has mode shapes at only " + std::to_string(candidates) + " places");
    std::vector<std::size_t> places;
    std::vector<double> clearance(candidates, std::numeric_limits<double>::infinity());
    auto last = object.mass.centreMetres;
    while (places.size() < count) {
        auto reach = clearance;
        for (std::size_t row = 0; row < candidates; ++row)
            reach[row] = std::min(reach[row], distance(vertexOfRow(object, row), last));
        if (!places.empty()) // the centre of mass is no place
            clearance = reach;
        places.push_back(static_cast<std::size_t>(std::ranges::max_element(reach) - reach.begin()));
        last = vertexOfRow(object, places.back());
    }
    return places;
}

} // namespace idiophone
