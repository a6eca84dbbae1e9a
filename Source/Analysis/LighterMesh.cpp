#include "Analysis/LighterMesh.h"

#include "Mesh/ObjectMesh.h"

#include <algorithm>
#include <utility>
#include <vector>

namespace idiophone {

Result<ModalObject> withLighterMesh(const ModalObject& object,
                                    const Mesh& lighter,
                                    const std::vector<int>& shapeVertices) {
    const Mesh mesh = objectMesh(object);
    std::vector<int> origin; // the object's nearest vertex for each vertex of the lighter mesh
    for (const auto& vertex : lighter.vertices.rowwise())
        origin.push_back(nearestVertex(mesh, vertex));
    auto distinct = origin;
    std::ranges::sort(distinct);
    if (std::ranges::adjacent_find(distinct) != distinct.end())
        return failure("Two vertices of the lighter mesh of \"" + object.name +
                       "\" go to one place.");

    ModalObject result = object;
    setMesh(result, {mesh.vertices(origin, Eigen::all), lighter.faces});
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
