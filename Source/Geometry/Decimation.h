// Reduces a scan to a vertex budget with little loss of shape. Triangles follow the curvature and
// are not equilateral; see Remesh for equilateral ones.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

namespace idiophone {

/// Collapses edges in the order of their quadric error (Garland & Heckbert 1997, by CGAL) until at
/// most `vertexBudget` ≥ 4 vertices are left. A mesh within the budget is only repaired. Repairs
/// the mesh first and cuts it where it is not a manifold (MeshRepair).
/// The result is an oriented manifold without degenerate faces. It is closed where the input was
/// closed. Vertices and faces have a new order.
/// Fails with one sentence if repair fails, if the topology (components, holes, handles) needs more
/// vertices than the budget, if thousands of faces meet in one vertex (cubic time), or if
/// cancelled. Never throws. Any thread except the audio thread.
Result<Mesh> decimate(const Mesh& mesh, int vertexBudget, const WorkControl& control = {});

} // namespace idiophone
