// Generates meshes of bars, plates, rings and spheres. Triangles are as nearly equilateral as the
// outline allows, because springs on other triangles are anisotropic. The box is an exception: it
// shows the zero modes of flat faces.
#pragma once

#include "Mesh/Mesh.h"

namespace idiophone {

/// The division of a sheet: rows of vertices along x, every other row shifted by half a spacing.
struct SheetGrid {
    int segmentsAlong = 2; ///< ≥ 2
    int rowsAcross = 2;    ///< number of spaces between rows, even and ≥ 2
};

/// Returns the grid of near-equilateral triangles with about `targetVertices` vertices. It always
/// has a vertex in the middle and is mirror-symmetric in x and y.
SheetGrid sheetGrid(double lengthMetres, double widthMetres, int targetVertices);

/// A flat rectangle in the xy plane, centred at the origin, length along x, normals along +z.
Mesh sheetMesh(double lengthMetres, double widthMetres, const SheetGrid& grid);
Mesh sheetMesh(double lengthMetres, double widthMetres, int targetVertices);

/// A flat disc in the xy plane: rings of 6, 12, 18, … vertices around the middle.
Mesh discMesh(double radiusMetres, int rings);

/// The closed surface of a box centred at the origin. Each side is a grid of triangles.
Mesh boxMesh(const Eigen::Vector3d& sizeMetres, const Eigen::Vector3i& segments);

/// A sphere: an icosahedron subdivided `level` times, with 10·4^level + 2 vertices.
Mesh icosphereMesh(double radiusMetres, int level);

/// A ring with a round section around the z axis; every other section is turned by half a spacing.
/// `sections` must be even.
Mesh torusMesh(double radiusMetres, double sectionRadiusMetres, int sections, int sidesOfSection);

/// An open cylinder (a hoop) around the z axis with triangles in shifted rows. `around` must be
/// even.
Mesh hoopMesh(double radiusMetres, double heightMetres, int around, int rows);

/// The closed surface of a thick tube around the z axis, centred at the origin: four circles of
/// `around` vertices.
Mesh tubeMesh(double outerRadiusMetres, double innerRadiusMetres, double lengthMetres, int around);

} // namespace idiophone
