#include "Geometry/Subdivision.h"

#include <algorithm>
#include <igl/loop.h>
#include <igl/remove_unreferenced.h>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

/// What libigl takes for granted, and writes beyond its matrices without: no edge is run along
/// twice in one direction, so that its faces are two at most, and agree.
bool facesAgree(const Eigen::MatrixXi& faces) {
    std::vector<std::pair<int, int>> edges;
    for (const auto& face : faces.rowwise())
        for (int k = 0; k < 3; ++k)
            edges.emplace_back(face(k), face((k + 1) % 3));
    std::ranges::sort(edges);
    return std::ranges::adjacent_find(edges) == edges.end() &&
           std::ranges::none_of(edges, [](const auto& edge) { return edge.first == edge.second; });
}

} // namespace

Mesh subdivided(const Mesh& mesh, int times) {
    if (mesh.faceCount() == 0 || !facesAgree(mesh.faces))
        return mesh;
    Mesh used; // libigl reads beyond its lists where a vertex has no face
    Eigen::VectorXi newNumbers;
    igl::remove_unreferenced(mesh.vertices, mesh.faces, used.vertices, used.faces, newNumbers);
    Mesh fine;
    igl::loop(used.vertices, used.faces, fine.vertices, fine.faces, times);
    return fine;
}

} // namespace idiophone
