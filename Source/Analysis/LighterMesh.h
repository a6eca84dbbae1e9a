// Replaces the mesh of an object by a lighter one, if the analysis needed a finer mesh than a file
// should hold.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/ModalObject.h"

#include <vector>

namespace idiophone {

/// Replaces the mesh for display and strikes. Each vertex of `lighter` moves to the nearest vertex
/// of the object. The vertices in `shapeVertices`, ascending, keep their shapes. Errors: a vertex
/// in `shapeVertices` without a shape, or two vertices that move to the same place.
Result<ModalObject> withLighterMesh(const ModalObject& object,
                                    const Mesh& lighter,
                                    const std::vector<int>& shapeVertices);

} // namespace idiophone
