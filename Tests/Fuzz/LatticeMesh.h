// Makes degenerate meshes from any bytes: vertices lie on a lattice of few points, so that faces
// meet, fold, repeat and pass through each other.
#pragma once

#include "Mesh/Mesh.h"

#include <string_view>

namespace idiophone::fuzz {

/// Reads a byte for the number of vertices, three bytes for each vertex, then three for each face.
/// Makes at most 64 vertices within about 16 units, and 200 faces. `bytes` is not empty.
Mesh latticeMesh(std::string_view bytes);

} // namespace idiophone::fuzz
