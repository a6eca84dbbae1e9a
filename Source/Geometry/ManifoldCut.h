// Cuts a mesh apart until it is a manifold, because halfedge structures need one. Internal to
// Geometry.
#pragma once

#include "Geometry/EdgePairing.h"
#include "Mesh/Mesh.h"

#include <vector>

namespace idiophone {

/// Gives every fan of faces connected through partners its own vertex. Each edge then has at most
/// two faces and each vertex one fan. Copies are appended and stay in place. If two pairs still
/// share both vertices, an edge gets a vertex in its middle. The faces must be oriented. A manifold
/// stays unchanged.
/// Returns for each vertex of the result the vertex that it copies, or −1 for the middle of an
/// edge.
std::vector<int> cutIntoManifold(Mesh& mesh, const EdgePairing& pairing);

} // namespace idiophone
