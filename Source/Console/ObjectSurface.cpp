#include "Console/ObjectSurface.h"

#include <algorithm>

namespace idiophone {
namespace {

Mesh meshOf(const ModalObject& object) {
    using Coordinates = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
    using Corners = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;
    const auto vertexCount = static_cast<Eigen::Index>(object.vertexCount());
    const auto faceCount = static_cast<Eigen::Index>(object.faceCount());
    return {
        .vertices =
            Eigen::Map<const Coordinates>(object.vertices.data(), vertexCount, 3).cast<double>(),
        .faces = Eigen::Map<const Corners>(object.faces.data(), faceCount, 3)};
}

} // namespace

ObjectSurface::ObjectSurface(const ModalObject& surfaceOf)
    : object(surfaceOf), normals(vertexNormals(surfaceOf)) {
    if (object.faceCount() > 0)
        query.emplace(meshOf(object));
}

std::optional<std::int32_t> ObjectSurface::rowOf(std::int64_t vertex) const {
    const auto found = std::ranges::lower_bound(object.shapeVertices, vertex);
    if (found == object.shapeVertices.end() || *found != vertex)
        return std::nullopt;
    return static_cast<std::int32_t>(found - object.shapeVertices.begin());
}

StrikePoint ObjectSurface::atRow(std::size_t row) const {
    const auto* normal = &normals[static_cast<std::size_t>(object.shapeVertices[row]) * 3];
    return {.shapeRows = {static_cast<std::int32_t>(row), 0, 0},
            .weights = {1, 0, 0},
            .normal = {normal[0], normal[1], normal[2]}};
}

std::optional<StrikePoint> ObjectSurface::atVertex(std::int64_t vertex) const {
    const auto row = rowOf(vertex);
    if (!row)
        return std::nullopt;
    return atRow(static_cast<std::size_t>(*row));
}

StrikePoint ObjectSurface::nearest(const std::array<double, 3>& pointMetres) const {
    if (!query)
        return atRow(nearestShapeRow(object, pointMetres));
    const auto surface = query->nearestPoint({pointMetres[0], pointMetres[1], pointMetres[2]});
    StrikePoint point;
    for (int corner = 0; corner < 3; ++corner) {
        const auto row = rowOf(query->mesh().faces(surface.face, corner));
        if (!row)
            return atRow(nearestShapeRow(object, pointMetres));
        const auto index = static_cast<std::size_t>(corner);
        point.shapeRows[index] = *row;
        point.weights[index] = static_cast<float>(surface.barycentric(corner));
        point.normal[index] = static_cast<float>(surface.normal(corner));
    }
    return point;
}

} // namespace idiophone
