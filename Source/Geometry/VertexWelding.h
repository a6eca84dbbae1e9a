// Merges close vertices, a first step of repair.
#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace idiophone {

/// Merges vertices within the tolerance of an earlier vertex, which stays in place. The remaining
/// ones are farther apart than the tolerance. Indices must be valid, coordinates finite. Returns
/// the new index of each old vertex.
std::vector<int> weldVertices(Mesh& mesh, double toleranceMetres);

} // namespace idiophone
