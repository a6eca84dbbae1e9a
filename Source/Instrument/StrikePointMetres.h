// Converts a strike point to a position on the mesh.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/Strike.h"

#include <array>

namespace idiophone {

/// Returns metres in the mesh's coordinates; the point's rows must be the object's. Any thread.
inline std::array<double, 3> strikePointMetres(const ModalObject& object,
                                               const StrikePoint& point) noexcept {
    std::array<double, 3> place{};
    for (std::size_t k = 0; k < point.weights.size(); ++k) {
        if (point.weights[k] == 0)
            continue;
        const auto row = static_cast<std::size_t>(point.shapeRows[k]);
        const auto vertex = static_cast<std::size_t>(object.shapeVertices[row]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            place[axis] += static_cast<double>(point.weights[k]) *
                           static_cast<double>(object.vertices[3 * vertex + axis]);
    }
    return place;
}

} // namespace idiophone
