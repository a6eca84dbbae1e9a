// Brings a scan down to a budget of vertices with little loss of shape. The triangles follow the
// curvature and are not equilateral: see Remesh for that.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

namespace idiophone {

/// Collapses edges in the order of their quadric error (Garland & Heckbert 1997, by CGAL) until at
/// most `vertexBudget` ≥ 4 vertices are left; a mesh within the budget is only repaired.
/// The mesh is repaired first and cut where it is no manifold (MeshRepair). The result is a
/// manifold, oriented, without degenerate faces, closed where it was closed; the order of vertices
/// and faces is new.
/// Fails, in one sentence, where repair does, when the topology (many components, holes, handles)
/// needs more vertices than the budget, when thousands of faces meet in one vertex (which would
/// take the cube of their number), or once cancelled. Never throws. Any thread; not for the audio
/// thread.
Result<Mesh> decimate(const Mesh& mesh, int vertexBudget, const WorkControl& control = {});

} // namespace idiophone
