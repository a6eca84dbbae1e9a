// Fills a solid body with 10-node tetrahedra. Repair, the check for self-intersection and remeshing
// come before it.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <array>
#include <atomic>
#include <utility>

namespace idiophone {

/// Node 4 + e of an element lies in the middle of edge e, which joins these corners.
inline constexpr std::array<std::pair<int, int>, 6> tetrahedronEdges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// P nodes and T elements. Nodes 0 … surfaceVertexCount − 1 are the surface's vertices, in its
/// order and exactly at their positions.
struct TetMesh {
    Eigen::MatrixXd nodes; ///< [P×3] in metres; each belongs to an element
    Eigen::MatrixXi
        tetrahedra; ///< [T×10] four corners of positive orientation, then mid-edge nodes
    int surfaceVertexCount = 0;
};

struct TetMeshSettings {
    double targetEdgeMetres = 0; ///< > 0: approximate maximum edge of the elements
    /// True keeps the surface's triangles and puts new nodes inside only. Use it if the surface has
    /// edges of the target length. In thin walls only this gives flat elements. False may divide
    /// the surface, which makes good elements from any coarse surface.
    bool keepSurface = true;
    int maximumNodes = 60000;                     ///< a body that needs more is an error
    const std::atomic<bool>* cancelled = nullptr; ///< true ends it within a second
};

/// Fills a closed surface. Cavities (closed surfaces inside another) stay empty, whatever their
/// orientation. Separate bodies may lie side by side. Mid-edge nodes lie on straight edges, because
/// only the triangles are known; CurvedEdges moves them to a finer surface.
///
/// The surface must be closed. Faces meet only at common edges or vertices, each vertex has a face,
/// and no two vertices coincide. TetGen 1.5 detects violations late or never. Errors are one
/// sentence, including `cancelledMessage`. Any thread may call it; calls take turns because TetGen
/// keeps its tolerances in globals.
Result<TetMesh> tetrahedralise(const Mesh& closedSurface, const TetMeshSettings& settings);

/// Returns ten-node elements for four-node ones [T×4], with nodes on the middles of all edges.
/// Elements of negative orientation are turned.
TetMesh withMidEdgeNodes(const Eigen::MatrixXd& points,
                         const Eigen::MatrixXi& tetrahedra,
                         int surfaceVertexCount);

double volumeM3(const TetMesh& mesh);

/// Returns the mean length of the edges between corners.
double meanEdgeLengthMetres(const TetMesh& mesh);

} // namespace idiophone
