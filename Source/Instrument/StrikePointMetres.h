// Converts a strike point to a position on the mesh.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/Strike.h"

#include <array>

namespace idiophone {

/// Returns metres in the mesh's coordinates; the point's rows must be the object's. Any thread.
std::array<double, 3> strikePointMetres(const ModalObject& object,
                                        const StrikePoint& point) noexcept;

} // namespace idiophone
