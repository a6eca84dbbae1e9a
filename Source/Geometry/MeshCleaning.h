// The first steps of repair: drop superfluous vertices and faces. MeshRepair puts the
// steps in order and reports them. Indices must be valid, coordinates finite.
#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace idiophone {

/// Keeps the first `count` vertices and gives the faces' corners their new numbers: `newNumber` of
/// each old number.
void renumberVertices(Mesh& mesh, int count, const std::vector<int>& newNumber);

/// Drops faces with two corners in one vertex or without area (height at most 1e-10 of the longest
/// side). Returns their number.
int dropDegenerateFaces(Mesh& mesh);

/// Keeps the first of all faces with the same three vertices, in any order. Returns the number of
/// dropped faces.
int dropDuplicateFaces(Mesh& mesh);

/// Keeps the connected component with the largest area. Returns the number of dropped components
/// that had faces.
int keepLargestComponent(Mesh& mesh);

/// Drops vertices without a face. Returns the new index of each old vertex, or −1.
std::vector<int> dropUnreferencedVertices(Mesh& mesh);

} // namespace idiophone
