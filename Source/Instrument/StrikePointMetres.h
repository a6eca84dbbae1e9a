// Where on its mesh an object is struck.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/Strike.h"

#include <array>

namespace idiophone {

/// In metres, in the mesh's coordinates; the point's rows are the object's. For any thread.
std::array<double, 3> strikePointMetres(const ModalObject& object,
                                        const StrikePoint& point) noexcept;

} // namespace idiophone
