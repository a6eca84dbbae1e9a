// Inserts vertices on the edges of faces. Internal to Geometry.
#pragma once

#include "Geometry/Mesh.h"

#include <array>
#include <unordered_map>
#include <vector>

namespace idiophone {

/// For a face the vertices to insert between its corner k and its corner k+1, in that order.
using EdgeInsertions = std::array<std::vector<int>, 3>;

/// Cuts each face named into triangles, one more for every vertex inserted; they take its place in
/// the order of the faces. The vertices lie on those edges, inside them.
void splitFaces(Mesh& mesh, const std::unordered_map<int, EdgeInsertions>& insertionsOfFace);

} // namespace idiophone
