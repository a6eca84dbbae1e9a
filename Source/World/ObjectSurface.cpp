// SPDX-License-Identifier: Apache-2.0
#include "World/ObjectSurface.h"

#include "Mesh/ShapeMesh.h"
#include "Synth/PlaceBetween.h"

#include <algorithm>

namespace idiophone {

ObjectSurface::ObjectSurface(const ModalObject& surfaceOf)
    : object(surfaceOf), normals(vertexNormals(surfaceOf)), query(shapeMesh(surfaceOf)) {}

std::array<float, 3> ObjectSurface::normalAt(std::int32_t row) const {
    const auto vertex = object.shapeVertices[static_cast<std::size_t>(row)];
    const auto* normal = &normals[static_cast<std::size_t>(vertex) * 3];
    return {normal[0], normal[1], normal[2]};
}

std::optional<StrikePoint> ObjectSurface::atVertex(std::int64_t vertex) const {
    const auto found = std::ranges::lower_bound(object.shapeVertices, vertex);
    if (found == object.shapeVertices.end() || *found != vertex)
        return std::nullopt;
    const auto row = static_cast<std::int32_t>(found - object.shapeVertices.begin());
    return StrikePoint{.shapeRows = {row}, .weights = {1}, .normal = normalAt(row)};
}

StrikePoint ObjectSurface::nearest(const std::array<double, 3>& pointMetres) const {
    const auto place = query.nearestPoint({pointMetres[0], pointMetres[1], pointMetres[2]});
    PlaceBetween between;
    for (int corner = 0; corner < 3; ++corner) {
        const std::int32_t row = query.mesh().faces(place.face, corner);
        between.add({.shapeRows = {row}, .weights = {1}, .normal = normalAt(row)},
                    place.barycentric(corner));
    }
    return between.point();
}

} // namespace idiophone
