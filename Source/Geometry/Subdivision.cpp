#include "Geometry/Subdivision.h"

#include <algorithm>
#include <igl/loop.h>
#include <igl/remove_unreferenced.h>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

/// Returns true if no edge is used twice in one direction. Then every edge has at most two faces,
/// which agree. libigl assumes this and otherwise writes out of bounds.
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
    Mesh used; // libigl reads out of bounds if a vertex has no face
    Eigen::VectorXi newNumbers;
    igl::remove_unreferenced(mesh.vertices, mesh.faces, used.vertices, used.faces, newNumbers);
    Mesh fine;
    igl::loop(used.vertices, used.faces, fine.vertices, fine.faces, times);
    return fine;
}

} // namespace idiophone
