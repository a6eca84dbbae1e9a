// A lighter mesh for an object that had to be analysed on a finer one than files should hold.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/ModalObject.h"

#include <vector>

namespace idiophone {

/// The object with this mesh to be drawn and struck instead, whose vertices go to the nearest of
/// its own, each to another; of them `shapeVertices`, ascending, keep their shapes. Errors: one of
/// these had none, or two vertices go to one place.
Result<ModalObject> withLighterMesh(const ModalObject& object,
                                    const Mesh& lighter,
                                    const std::vector<int>& shapeVertices);

} // namespace idiophone
