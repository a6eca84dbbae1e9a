// Joins faces along an edge that only one of them has a vertex on. Internal to Geometry.
#pragma once

#include "Geometry/Mesh.h"

namespace idiophone {

/// A mesh with more edges of a single face than this is a soup of triangles.
inline constexpr int mostOpenEdges = 200'000;

/// Splits every edge of a single face at the boundary vertices that lie on it, nearer than the
/// tolerance (and farther than that from its ends), so that the faces on its other side can join.
/// The edge then runs through those vertices, which stay where they are. Returns the number of
/// vertices put in. A mesh with more of them than twice its boundary edges is a tangle and keeps
/// the rest; one with more than `mostOpenEdges` edges of a single face is left as it is. Degenerate
/// and duplicate faces have been dropped before, and may appear.
int splitTJunctions(Mesh& mesh, double toleranceMetres);

} // namespace idiophone
