// Covers a surface with near-equilateral triangles of a given size, as springs and tetrahedra need
// them. To reduce a scan without regard to triangle shape, see Decimation.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"
#include "Object/WorkControl.h"

namespace idiophone {

/// Returns about how many triangles of an edge length remeshing needs, slivers included: many for a
/// long needle, although its area is small.
double remeshedTriangles(const Mesh& mesh, double edgeLengthMetres);

/// Isotropic remeshing (Botsch & Kobbelt 2004, by CGAL). New vertices lie on the given mesh; its
/// boundary stays in place. Most edges get 4/5 to 4/3 of the target length, and shorter ones where
/// sharp edges are closer than that. Edges where the surface turns by more than 40° are kept.
/// Corners of such edges and of the boundary stay in place.
/// Decimates a mesh far denser than the target first: scans take a fifth of the time, and their
/// noise is not taken for sharp edges. Repairs the mesh and cuts it where it is not a manifold
/// (MeshRepair). Parts connected only at such places are separated; RepairReport::nonManifoldEdges
/// counts these places.
///
/// The result is an oriented manifold without degenerate faces, but may intersect itself. Vertices
/// and faces have a new order.
/// Fails with one sentence if repair fails, if the edge length is not above 0 and at most half the
/// bounding diagonal, if it needs more than 4 million triangles, if tens of thousands of faces meet
/// in one vertex, or if cancelled. Never throws. Any thread except the audio thread.
Result<Mesh> remesh(const Mesh& mesh, double edgeLengthMetres, const WorkControl& control = {});

} // namespace idiophone
