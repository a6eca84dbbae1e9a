// Joins faces along an edge on which only one side has a vertex. Internal to Geometry.
#pragma once

#include "Mesh/Mesh.h"

namespace idiophone {

/// A mesh with more edges of a single face than this is treated as a soup of triangles.
inline constexpr int maximumOpenEdges = 200'000;

/// Splits every edge of a single face at the boundary vertices on it, so that the faces on its
/// other side can join. A vertex is on the edge if it is closer to the edge than the tolerance, but
/// not as close to an end. The edge then runs through the vertices, which stay in place. Returns
/// the number of insertions.
/// Stops when insertions exceed twice the boundary edges (plus 1,000): such a mesh is a tangle.
/// Does nothing if more than `maximumOpenEdges` edges have a single face. Drop degenerate and
/// duplicate faces before and after: new ones may appear.
int splitTJunctions(Mesh& mesh, double toleranceMetres);

} // namespace idiophone
