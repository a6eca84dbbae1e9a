// A solid body cut into 10-node tetrahedra. It takes the surface as it is: repair,
// self-intersection and remeshing come before it.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <array>
#include <atomic>
#include <utility>

namespace idiophone {

/// Node 4 + e of an element lies in the middle of edge e, which joins these corners.
inline constexpr std::array<std::pair<int, int>, 6> tetrahedronEdges{
    {{0, 1}, {1, 2}, {2, 0}, {0, 3}, {1, 3}, {2, 3}}};

/// P nodes and T elements. Nodes 0 … surfaceVertexCount − 1 are the vertices of the surface, in its
/// order and exactly at their places.
struct TetMesh {
    Eigen::MatrixXd nodes; ///< [P×3] in metres; every one belongs to an element
    Eigen::MatrixXi
        tetrahedra; ///< [T×10] four corners of positive orientation, then mid-edge nodes
    int surfaceVertexCount = 0;
};

struct TetMeshSettings {
    double targetEdgeMetres = 0; ///< > 0: elements have no more than about this edge
    /// True leaves the surface's triangles as they are and puts new nodes inside only: right where
    /// the surface already has edges of the target length, and the only way to flat elements in
    /// thin walls. False may divide the surface, which makes good elements of any coarse surface.
    bool keepSurface = true;
    int maximumNodes = 60000;                     ///< a body that needs more is refused
    const std::atomic<bool>* cancelled = nullptr; ///< set to true, it ends within a second
};

/// Fills a closed surface. Cavities (closed surfaces inside another) stay empty, whichever way
/// their faces look; separate bodies may stand side by side. Mid-edge nodes lie on straight edges,
/// also where the true body curves: the triangles of the surface are all that is known of it.
///
/// The surface should be closed, with no face that meets another but in a common edge or vertex, a
/// face for every vertex, and no two vertices in one place, for TetGen 1.5 finds violations late or
/// never. Errors are one sentence, `cancelledMessage` among them. May be called on any thread;
/// calls take turns, for TetGen keeps its tolerances in globals.
Result<TetMesh> tetrahedralise(const Mesh& closedSurface, const TetMeshSettings& settings);

/// The enclosed volume of a mesh's elements.
double volumeM3(const TetMesh& mesh);

/// The mean length of the edges between corners.
double meanEdgeLengthMetres(const TetMesh& mesh);

} // namespace idiophone
