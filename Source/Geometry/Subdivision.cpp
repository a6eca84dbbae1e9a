#include "Geometry/Subdivision.h"

#include "Geometry/MeshCleaning.h"

#include <algorithm>
#include <igl/loop.h>
#include <map>
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

FaceSplit splitInFour(const Mesh& mesh) {
    const auto before = static_cast<int>(mesh.vertexCount());
    std::vector<Eigen::Triplet<double>> shares;
    for (int vertex = 0; vertex < before; ++vertex)
        shares.emplace_back(vertex, vertex, 1.0);
    std::map<std::pair<int, int>, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [at, isNew] =
            middles.try_emplace(std::minmax(a, b), before + static_cast<int>(middles.size()));
        if (isNew)
            for (const int end : {a, b})
                shares.emplace_back(at->second, end, 0.5);
        return at->second;
    };
    FaceSplit split{{}, Eigen::MatrixXi(4 * mesh.faceCount(), 3)};
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        const Eigen::RowVector3i corners = mesh.faces.row(face);
        Eigen::RowVector3i between;
        for (int k = 0; k < 3; ++k)
            between(k) = middle(corners(k), corners((k + 1) % 3));
        for (int k = 0; k < 3; ++k)
            split.faces.row(4 * face + k) << corners(k), between(k), between((k + 2) % 3);
        split.faces.row(4 * face + 3) = between;
    }
    split.vertices.resize(before + static_cast<int>(middles.size()), before);
    split.vertices.setFromTriplets(shares.begin(), shares.end());
    return split;
}

Mesh subdivided(const Mesh& mesh, int times) {
    if (mesh.faceCount() == 0 || !facesAgree(mesh.faces))
        return mesh;
    Mesh used = mesh; // libigl reads out of bounds if a vertex has no face
    dropUnreferencedVertices(used);
    Mesh fine;
    igl::loop(used.vertices, used.faces, fine.vertices, fine.faces, times);
    return fine;
}

} // namespace idiophone
