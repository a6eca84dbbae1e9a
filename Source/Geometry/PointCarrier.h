// A surface that carries what is known at a few points only: through the points, or a mesh that
// they lie on, with how much each point counts at each vertex.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <span>

namespace idiophone {

struct PointCarrier {
    Mesh mesh;
    Eigen::MatrixXd weights; ///< [N, points] ≥ 0, each row's sum 1
};

/// Points as a surface has them: those of one line get a strip a tenth as wide to either side, a
/// single one a disc of 1 cm, others their Delaunay triangulation in the plane that fits them best.
/// Every point is a vertex, at which it alone counts. At least one point, no two in one place.
PointCarrier carrierThrough(std::span<const Eigen::Vector3d> points);

/// For what is the same all around the z axis: a flat disc of rings of vertices at those radii in
/// metres, ascending, ≥ 0. The innermost counts at the centre.
PointCarrier discOfRadii(std::span<const double> radiiMetres);

/// The mesh as it is; each point counts by the inverse square of its distance (Shepard 1968).
PointCarrier carriedBy(Mesh mesh, std::span<const Eigen::Vector3d> points);

/// The same for what only depends on the distance from the z axis, linear between the radii.
PointCarrier carriedBy(Mesh mesh, std::span<const double> radiiMetres);

} // namespace idiophone
