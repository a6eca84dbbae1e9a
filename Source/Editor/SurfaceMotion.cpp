#include "Editor/SurfaceMotion.h"

#include "Mesh/ShapeMesh.h"
#include "Mesh/SurfaceQuery.h"

#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

constexpr std::int64_t boxesForSurface = 50'000'000; // search limit, about 1 to 2 s

} // namespace

SurfaceMotion::SurfaceMotion(std::shared_ptr<const ModalObject> moved) : object(std::move(moved)) {
    const SurfaceQuery surface(shapeMesh(*object));
    places.reserve(object->vertexCount());
    std::int64_t boxesLeft = boxesForSurface;
    for (std::size_t vertex = 0; vertex < object->vertexCount(); ++vertex) {
        const float* at = object->vertices.data() + 3 * vertex;
        const auto nearest =
            surface.nearestPoint(Eigen::Vector3f(at[0], at[1], at[2]).cast<double>(), boxesLeft);
        Place place;
        for (int corner = 0; corner < 3; ++corner) {
            const auto index = static_cast<std::size_t>(corner);
            place.rows[index] = surface.mesh().faces(nearest.face, corner);
            if (std::isfinite(nearest.distanceMetres))
                place.weights[index] = static_cast<float>(nearest.barycentric(corner));
        }
        places.push_back(place);
    }
}

float SurfaceMotion::largest(std::size_t mode) const {
    float square = 0;
    for (std::size_t row = 0; row < object->shapeVertexCount(); ++row) {
        const auto shape = object->shapesAt(row).subspan(3 * mode, 3);
        square = std::max(square, shape[0] * shape[0] + shape[1] * shape[1] + shape[2] * shape[2]);
    }
    return std::sqrt(square);
}

void SurfaceMotion::add(std::size_t mode, float weight, std::span<float> displacements) const {
    const float maximum = largest(mode);
    if (maximum <= 0)
        return;
    for (std::size_t vertex = 0; vertex < places.size(); ++vertex)
        for (std::size_t corner = 0; corner < 3; ++corner) {
            const auto& [rows, weights] = places[vertex];
            const auto shape =
                object->shapesAt(static_cast<std::size_t>(rows[corner])).subspan(3 * mode, 3);
            const float scale = weight / maximum * weights[corner];
            for (std::size_t axis = 0; axis < 3; ++axis)
                displacements[3 * vertex + axis] += scale * shape[axis];
        }
}

} // namespace idiophone
