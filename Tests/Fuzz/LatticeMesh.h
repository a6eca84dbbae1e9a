// Meshes that no modeller would write, of any bytes: corners on a lattice of few points, so that
// faces meet, fold, repeat and pass through each other.
#pragma once

#include "Geometry/Mesh.h"

#include <string_view>

namespace idiophone::fuzz {

/// A byte that says how many vertices there are, three bytes for each, then three for each face. At
/// most 64 vertices within about 16 units, and 200 faces. Not of no bytes.
Mesh latticeMesh(std::string_view bytes);

} // namespace idiophone::fuzz
