// A surface for values that are known at a few points only: a mesh through the points or a mesh
// that contains them, and the weight of each point at each vertex.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <span>

namespace idiophone {

struct PointCarrier {
    Mesh mesh;
    Eigen::MatrixXd weights; ///< [N, points] ≥ 0, each row sums to 1
};

/// Builds a surface through the points. A single point becomes a disc of 1 cm radius. Points on a
/// line become a strip that extends to either side by a tenth of its length. Other points get their
/// Delaunay triangulation in the best-fit plane. Every point is a vertex with weight 1. Needs at
/// least one point, and no two at the same position.
PointCarrier carrierThrough(std::span<const Eigen::Vector3d> points);

/// For values that depend only on the distance from the z axis: a flat disc with rings of vertices
/// at these radii in metres, ascending, ≥ 0. The centre has the innermost radius's value.
PointCarrier discOfRadii(std::span<const double> radiiMetres);

/// Keeps the mesh. Weights are the inverse squares of the distances to the points (Shepard 1968).
PointCarrier carriedBy(Mesh mesh, std::span<const Eigen::Vector3d> points);

/// Keeps the mesh, for values that depend only on the distance from the z axis. Weights are linear
/// between the radii.
PointCarrier carriedBy(Mesh mesh, std::span<const double> radiiMetres);

} // namespace idiophone
