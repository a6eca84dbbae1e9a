// Inserts vertices on the edges of faces. Internal to Geometry.
#pragma once

#include "Mesh/Mesh.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace idiophone {

/// The vertices to insert into one face, in order from its corner k to its corner k+1.
using EdgeInsertions = std::array<std::vector<int>, 3>;

/// Cuts each listed face into triangles, one more per inserted vertex. They replace it at its
/// position in the face order. The inserted vertices must lie inside those edges.
void splitFaces(Mesh& mesh, const std::unordered_map<int, EdgeInsertions>& insertionsOfFace);

} // namespace idiophone
