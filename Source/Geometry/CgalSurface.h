// Converts meshes to CGAL's halfedge structure and back. Only Remesh and Decimation include it,
// because CGAL compiles slowly. Internal to Geometry.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>
#include <exception>
#include <new>
#include <string>

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

/// Thrown through CGAL's loops, which nothing else can end.
struct Stopped {
    std::string sentence;
};

/// Runs `work` and turns every exception into an error. `done` is its verb: "remeshed".
template <class Work>
Result<Mesh> withoutExceptions(const std::string& done, const Work& work) {
    try {
        return work();
    } catch (const Stopped& stop) {
        return failure(stop.sentence);
    } catch (const std::bad_alloc&) {
        return failure("The mesh needs more memory to be " + done + " than this machine has.");
    } catch (const std::exception& error) {
        return failure("The mesh cannot be " + done + ": " + error.what() + ".");
    }
}

} // namespace idiophone
