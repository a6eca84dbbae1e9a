// Meshes of bent rods: a round section that follows a path.
#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace idiophone {

/// The closed surface of a round rod along a path of at least two points, with flat ends. The path
/// bends by less than a right angle at a point, and more gently than the rod's radius. Each point
/// has a circle of `sides` ≥ 3 vertices, which does not turn about the path.
Mesh rodMesh(const std::vector<Eigen::Vector3d>& pathMetres, double radiusMetres, int sides);

/// Returns a path of straight lines between the corners, with an arc of this radius at each inner
/// corner, and points at most `stepMetres` apart.
std::vector<Eigen::Vector3d> roundedPath(const std::vector<Eigen::Vector3d>& cornersMetres,
                                         double bendRadiusMetres,
                                         double stepMetres);

} // namespace idiophone
