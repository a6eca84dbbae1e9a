// Generated meshes: the bars, plates, rings and spheres that instruments are made of.
// Triangles are as nearly equilateral as the outline allows, because springs on other triangles are
// anisotropic; the box is the exception, for it exists to show the zero modes of flat faces.
#pragma once

#include "Geometry/Mesh.h"

namespace idiophone {

/// How a sheet is divided: rows of vertices along x, every other row shifted by half a spacing.
struct SheetGrid {
    int segmentsAlong = 2; ///< ≥ 2
    int rowsAcross = 2;    ///< spaces between rows, even and ≥ 2
};

/// The grid of near-equilateral triangles with about `targetVertices` vertices. It always has a
/// vertex in the middle, and is mirror-symmetric in x and y.
SheetGrid sheetGrid(double lengthMetres, double widthMetres, int targetVertices);

/// A flat rectangle in the xy plane, centred at the origin, length along x, normals along +z.
Mesh sheetMesh(double lengthMetres, double widthMetres, const SheetGrid& grid);
Mesh sheetMesh(double lengthMetres, double widthMetres, int targetVertices);

/// A flat disc in the xy plane: rings of 6, 12, 18, … vertices about the middle.
Mesh discMesh(double radiusMetres, int rings);

/// The closed surface of a box centred at the origin, each side a grid cut into triangles.
Mesh boxMesh(const Eigen::Vector3d& sizeMetres, const Eigen::Vector3i& segments);

/// An icosahedron subdivided `level` times onto its sphere: 10·4^level + 2 vertices.
Mesh icosphereMesh(double radiusMetres, int level);

/// A ring with a round section about the z axis; every other section is turned by half a spacing.
/// `sections` is even.
Mesh torusMesh(double radiusMetres, double sectionRadiusMetres, int sections, int sidesOfSection);

/// An open cylinder (a hoop) about the z axis, `around` even, triangles in shifted rows.
Mesh hoopMesh(double radiusMetres, double heightMetres, int around, int rows);

/// The closed surface of a thick tube about the z axis: four circles of `around` vertices, centred
/// at the origin.
Mesh tubeMesh(double outerRadiusMetres, double innerRadiusMetres, double lengthMetres, int around);

} // namespace idiophone
