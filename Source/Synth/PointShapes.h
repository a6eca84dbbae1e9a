// The shapes of an object at a point of its surface, as the kernels read them.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/Strike.h"
#include "Synth/StrikeKernel.h"

namespace idiophone {

/// Returns the shapes from mode `firstMode` on. They point into the object; the point's rows must
/// exist.
inline ShapePoint pointShapes(const ModalObject& object,
                              const StrikePoint& point,
                              std::size_t firstMode = 0) noexcept {
    ShapePoint shapes;
    for (std::size_t k = 0; k < point.weights.size(); ++k)
        if (point.weights[k] != 0) {
            const auto row = static_cast<std::size_t>(point.shapeRows[k]);
            shapes.rows[shapes.used] = object.shapesAt(row).data() + 3 * firstMode;
            shapes.weights[shapes.used++] = point.weights[k];
        }
    return shapes;
}

} // namespace idiophone
