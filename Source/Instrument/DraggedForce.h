// The force of something hard that is dragged over a surface.
#pragma once

#include "Synth/ForceCell.h"

#include <array>
#include <cstddef>

namespace idiophone {

/// For each newton one into the surface, and `friction` along its way: unit, or zero where there is
/// none.
inline ForcePoint
draggedForce(const StrikePoint& point, const std::array<float, 3>& direction, double friction) {
    ForcePoint force{.point = point, .direction = {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        force.direction[axis] = static_cast<float>(friction) * direction[axis] - point.normal[axis];
    return force;
}

} // namespace idiophone
