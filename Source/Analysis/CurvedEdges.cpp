#include "Analysis/CurvedEdges.h"

#include "Analysis/QuadraticTetrahedra.h"

#include <algorithm>
#include <set>
#include <utility>

namespace idiophone {
namespace {

// Shares of an edge's length that its middle moves: rounding moves less, wrong walls more.
constexpr double flatShare = 1e-6, largestShare = 0.2;
constexpr double leastVolume = 0.3; ///< see leastVolumeShare

std::set<std::pair<int, int>> edgesOf(const Mesh& mesh) {
    std::set<std::pair<int, int>> edges;
    for (const auto& face : mesh.faces.rowwise())
        for (int k = 0; k < 3; ++k)
            edges.insert(std::minmax({face(k), face((k + 1) % 3)}));
    return edges;
}

/// Returns whether a node has moved.
bool straighten(TetMesh& mesh, Eigen::Index t) {
    bool hasMoved = false;
    for (int e = 0; e < 6; ++e) {
        const auto [a, b] = tetrahedronEdges[e];
        auto node = mesh.nodes.row(mesh.tetrahedra(t, 4 + e));
        const Eigen::RowVector3d middle =
            (mesh.nodes.row(mesh.tetrahedra(t, a)) + mesh.nodes.row(mesh.tetrahedra(t, b))) / 2;
        hasMoved = hasMoved || node != middle;
        node = middle;
    }
    return hasMoved;
}

} // namespace

void curveEdges(TetMesh& mesh, const Mesh& covering, const SurfaceQuery& trueSurface) {
    auto edges = edgesOf(covering);
    for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
        for (int e = 0; e < 6; ++e) {
            const auto [a, b] = std::minmax({mesh.tetrahedra(t, tetrahedronEdges[e].first),
                                             mesh.tetrahedra(t, tetrahedronEdges[e].second)});
            if (edges.erase({a, b}) == 0)
                continue;
            auto node = mesh.nodes.row(mesh.tetrahedra(t, 4 + e));
            const double length = (mesh.nodes.row(a) - mesh.nodes.row(b)).norm();
            const auto nearest = trueSurface.nearestPoint(node.transpose());
            if (nearest.distanceMetres > flatShare * length &&
                nearest.distanceMetres < largestShare * length)
                node = nearest.pointMetres.transpose();
        }
    for (bool hasMoved = true; hasMoved;) {
        hasMoved = false;
        for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t)
            if (leastVolumeShare(nodesOf(mesh, t)) < leastVolume)
                hasMoved = straighten(mesh, t) || hasMoved;
    }
}

} // namespace idiophone
