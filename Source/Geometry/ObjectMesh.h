// A modal object's own mesh, and normals to draw it with. ShapeMesh has the part where shapes are.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/ModalObject.h"

namespace idiophone {

Mesh objectMesh(const ModalObject& object);

/// Gives the object this mesh, in single precision, instead of its own.
void setMesh(ModalObject& object, const Mesh& mesh);

/// [3F×3] unit normals of the corners of all faces, three rows a face: the mean over the faces
/// around the corner that turn from its own by less than the crease angle, so that edges stay
/// sharp. Where more than 64 faces meet it is the mean over all of them, or the face's own if that
/// turns by more. Zero where the face has no area.
Eigen::MatrixXd cornerNormals(const Mesh& mesh, double creaseDegrees = 35);

} // namespace idiophone
