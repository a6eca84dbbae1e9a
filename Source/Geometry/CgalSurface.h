// Converts meshes to CGAL's halfedge structure and back. Only Remesh and Decimation include it,
// because CGAL compiles slowly. Internal to Geometry.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace idiophone {

using SurfaceKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<SurfaceKernel::Point_3>;

/// A surface centred at the origin with a bounding diagonal of 1, so that library tolerances do not
/// depend on the mesh's size.
struct UnitSurface {
    Surface surface;
    Eigen::RowVector3d centreMetres = Eigen::RowVector3d::Zero();
    double diagonalMetres = 1;

    Eigen::RowVector3d unitPoint(Surface::Vertex_index vertex) const;
};

/// Converts a mesh that repairMesh has cut into a manifold.
UnitSurface unitSurfaceOf(const Mesh& sound);

/// Removes deleted elements from the surface and returns it as a mesh in metres: a manifold without
/// degenerate faces. Fails with one sentence if no face is left.
Result<Mesh> meshOf(UnitSurface& surface);

} // namespace idiophone
