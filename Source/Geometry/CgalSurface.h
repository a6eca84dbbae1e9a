// Meshes as CGAL's halfedge structure and back, for Remesh and Decimation alone: it includes CGAL,
// which takes its time to compile. Internal to Geometry.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

namespace idiophone {

using SurfaceKernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Surface = CGAL::Surface_mesh<SurfaceKernel::Point_3>;

/// A surface about the origin with a bounding diagonal of 1, so that no tolerance of a library sees
/// metres.
struct UnitSurface {
    Surface surface;
    Eigen::RowVector3d centreMetres = Eigen::RowVector3d::Zero();
    double diagonalMetres = 1;

    Eigen::RowVector3d unitPoint(Surface::Vertex_index vertex) const;
};

/// Of a mesh that repairMesh has cut into a manifold.
UnitSurface unitSurfaceOf(const Mesh& sound);

/// The mesh in metres of a surface, of which removed parts may be left: a manifold without
/// degenerate faces. Fails, in one sentence, where nothing of it is left.
Result<Mesh> meshOf(UnitSurface& surface);

} // namespace idiophone
