// Cuts a mesh apart until it is a manifold, which halfedge structures ask for. Internal to
// Geometry.
#pragma once

#include "Geometry/EdgePairing.h"
#include "Geometry/Mesh.h"

#include <vector>

namespace idiophone {

/// Gives every fan of faces that hang together through partners a vertex of its own, so that each
/// edge has at most two faces and each vertex one fan. Copies stand where their vertex stands, at
/// the end. Where two pairs of faces cannot be told apart by their vertices even then, an edge gets
/// a vertex in its middle. The faces are oriented; a manifold stays as it is. Returns for each
/// vertex of the result the vertex that it copies, or −1 for one in the middle of an edge.
std::vector<int> cutIntoManifold(Mesh& mesh, const EdgePairing& pairing);

} // namespace idiophone
