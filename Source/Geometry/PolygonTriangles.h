// Cuts the polygons of mesh files into triangles. Internal to Geometry.
#pragma once

#include <Eigen/Core>
#include <array>
#include <vector>

namespace idiophone {

struct PolygonTriangles {
    std::vector<std::array<int, 3>> corners; ///< rows of the polygon, in its order around
    /// The outline crosses itself, also as seen across its best plane: the triangles are a fan,
    /// which may overlap.
    bool isGuess = false;
};

/// Cuts a polygon of at least three corners [N×3], in any unit. It is a fan from the first corner
/// if all triangles of the fan lie inside the outline, as in convex polygons. Otherwise the
/// triangles are those of a constrained Delaunay triangulation across the polygon's best plane.
/// They fill the outline, which may be concave and touch itself, as polygons with a cut to a hole
/// do. Takes O(n log n) time.
PolygonTriangles trianglesOf(const Eigen::MatrixX3d& polygon);

} // namespace idiophone
