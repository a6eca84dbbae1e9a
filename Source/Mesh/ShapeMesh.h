// SPDX-License-Identifier: Apache-2.0
// The part of a modal object's surface where its shapes are known: a mesh between the vertices with
// shapes. Shapes are linear over its faces. SurfaceQuery finds positions on it.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/ModalObject.h"

namespace idiophone {

/// Builds the mesh. Vertex i is the vertex of row i of `ModalObject::shapeVertices` (at least one).
/// If every vertex has shapes, the faces are the object's own. Otherwise each vertex of the object
/// belongs to its nearest vertex with shapes. Faces remain where three such cells meet: the
/// Delaunay triangulation on the surface, dual to its Voronoi cells.
///
/// Regions farther from the shapes than the shapes' spacing stay open. Faces against the back of
/// other faces, such as the underside of a bar with shapes on top, stay open too. A row without a
/// face gets a face without area, so that every row can be found and the mesh has a face.
Mesh shapeMesh(const ModalObject& object);

} // namespace idiophone
