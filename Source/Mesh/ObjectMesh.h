// SPDX-License-Identifier: Apache-2.0
// A modal object's own mesh, and normals for drawing it. ShapeMesh covers the part where shapes are
// known.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/ModalObject.h"

namespace idiophone {

Mesh objectMesh(const ModalObject& object);

/// Replaces the object's mesh, in single precision.
void setMesh(ModalObject& object, const Mesh& mesh);

/// Returns [3F×3] unit normals of all face corners, three rows per face. Each is the mean over the
/// faces around the corner that turn from its own by less than the crease angle, so that edges stay
/// sharp. If more than 64 faces meet, it is the mean over all of them, or the face's own normal if
/// the mean turns too far. Zero if the face has no area.
Eigen::MatrixXd cornerNormals(const Mesh& mesh, double creaseDegrees = 35);

} // namespace idiophone
