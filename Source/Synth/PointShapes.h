// SPDX-License-Identifier: Apache-2.0
// The shapes of an object at a point of its surface, as the kernels read them.
#pragma once

#include "Object/ModalObject.h"
#include "Synth/AllFinite.h"
#include "Synth/ForceCell.h"
#include "Synth/StrikeKernel.h"

#include <cmath>

namespace idiophone {

/// Returns whether the point's rows and radiation direction exist and its values are finite.
inline bool isOn(const ModalObject& object, const StrikePoint& point) noexcept {
    const auto rows = static_cast<std::int64_t>(object.shapeVertexCount());
    for (std::size_t k = 0; k < point.weights.size(); ++k) {
        const std::int64_t row = point.shapeRows[k];
        if (point.weights[k] != 0 && (row < 0 || row >= rows))
            return false;
    }
    const auto directions = static_cast<std::int64_t>(object.radiation.directions.size());
    return point.radiationDirection >= -1 && point.radiationDirection < directions &&
           object.modeCount() > 0 && allFinite(point.weights) && allFinite(point.normal);
}

/// Returns the same for the points of a place that are read.
inline bool isOn(const ModalObject& object, const ForcePlace& place) noexcept {
    const auto isValid = [&](const ForcePoint& at) {
        return isOn(object, at.point) && allFinite(at.direction);
    };
    return std::isfinite(place.fraction) && isValid(place.points[0]) &&
           (place.fraction == 0 || isValid(place.points[1]));
}

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
