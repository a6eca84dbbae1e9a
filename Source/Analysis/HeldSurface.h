// The held part of a mesh, which is found again on another mesh of the same body.
#pragma once

#include "Analysis/Clamp.h"
#include "Mesh/SurfaceQuery.h"
#include "Object/Result.h"

#include <memory>

namespace idiophone {

/// Immutable; any number of threads may use it.
class HeldSurface {
public:
    /// Takes the faces and vertices of a support of this mesh, in metres. Returns null if there are
    /// none. Error, one sentence: one of them does not exist.
    static Result<std::shared_ptr<const HeldSurface>> of(const Mesh& mesh, const Support& support);

    /// Returns whether the point of the mesh nearest to this one is held, and not farther away than
    /// `reachMetres`.
    bool holds(const Eigen::Vector3d& pointMetres, double reachMetres) const;

private:
    HeldSurface(Mesh held, const Mesh& whole);

    double toleranceMetres = 0;
    SurfaceQuery held;  ///< edges and vertices are triangles without an area
    SurfaceQuery whole; ///< with all faces
};

} // namespace idiophone
