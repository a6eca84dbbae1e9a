// The first steps of repair: vertices and faces that should not be there. MeshRepair puts the steps
// in order and reports them. Indices are valid, coordinates finite.
#pragma once

#include "Geometry/Mesh.h"

#include <vector>

namespace idiophone {

/// Makes vertices one that are within the tolerance of the first of them, which stays where it is.
/// Those that are left are farther apart than that. Returns for each old vertex its new number.
std::vector<int> weldVertices(Mesh& mesh, double toleranceMetres);

/// Drops faces with two corners in one vertex or no area (the height at most 1e-10 of the longest
/// side). Returns how many.
int dropDegenerateFaces(Mesh& mesh);

/// Of faces with the same three vertices, in any order, the first stays. Returns how many went.
int dropDuplicateFaces(Mesh& mesh);

/// Keeps the connected component with the greatest area. Returns how many others had faces.
int keepLargestComponent(Mesh& mesh);

/// Drops vertices of no face; returns for each old vertex its new number or −1.
std::vector<int> dropUnreferencedVertices(Mesh& mesh);

} // namespace idiophone
