#include "Analysis/LighterMesh.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

using Places = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Returns the object's nearest vertex for each vertex of the lighter mesh.
std::vector<std::int32_t> nearestVertices(const Places& places, const Mesh& lighter) {
    std::vector<std::int32_t> nearest;
    for (const auto& vertex : lighter.vertices.rowwise()) {
        Eigen::Index found = 0;
        (places.rowwise() - vertex.cast<float>()).rowwise().squaredNorm().minCoeff(&found);
        nearest.push_back(static_cast<std::int32_t>(found));
    }
    return nearest;
}

} // namespace

Result<ModalObject> withLighterMesh(const ModalObject& object,
                                    const Mesh& lighter,
                                    const std::vector<int>& shapeVertices) {
    const Places places = Eigen::Map<const Places>(object.vertices.data(), object.vertexCount(), 3);
    const auto origin = nearestVertices(places, lighter);
    auto distinct = origin;
    std::ranges::sort(distinct);
    if (std::ranges::adjacent_find(distinct) != distinct.end())
        return failure("Two vertices of the lighter mesh of \"" + object.name +
                       "\" go to one place.");

    ModalObject result = object;
    result.vertices.clear();
    for (const auto vertex : origin)
        result.vertices.insert(result.vertices.end(), places.row(vertex).begin(),
                               places.row(vertex).end());
    result.faces.clear();
    for (const auto& face : lighter.faces.rowwise())
        result.faces.insert(result.faces.end(), face.begin(), face.end());
    result.shapes.clear();
    for (const int vertex : shapeVertices) {
        const auto wanted = origin[vertex];
        const auto row = std::ranges::lower_bound(object.shapeVertices, wanted);
        if (row == object.shapeVertices.end() || *row != wanted)
            return failure(
                "The object \"" + object.name +
                "\" has no shapes at a vertex of its lighter mesh that is to keep them.");
        const auto shapes = object.shapesAt(row - object.shapeVertices.begin());
        result.shapes.insert(result.shapes.end(), shapes.begin(), shapes.end());
    }
    result.shapeVertices.assign(shapeVertices.begin(), shapeVertices.end());
    return validated(std::move(result));
}

} // namespace idiophone
