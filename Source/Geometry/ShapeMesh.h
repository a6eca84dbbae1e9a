// The part of a modal object's surface on which its shapes are known: a mesh between the vertices
// that carry them, so that shapes are linear over its faces. SurfaceQuery finds places on it.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/ModalObject.h"

namespace idiophone {

/// Vertex i is the vertex of row i of `ModalObject::shapeVertices`, of which there is at least one.
/// Where every vertex carries shapes these are the object's own faces. Where only some do, each
/// vertex of the object counts as its nearest one that does, and the faces between three of those
/// are what remains: the Delaunay triangulation on the surface, dual to its Voronoi cells. What
/// lies farther from the shapes than these are from one another stays open, and so does what would
/// lie flat against them from behind, as the underside of a bar with shapes on top. A row of no
/// face gets one of no area, so that every row can be found and the mesh has a face.
Mesh shapeMesh(const ModalObject& object);

} // namespace idiophone
