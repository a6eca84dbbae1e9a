// The force of a hard tool dragged over a surface.
#pragma once

#include "Synth/ForceCell.h"

#include <array>
#include <cstddef>

namespace idiophone {

/// Returns the force per newton of pressure: one newton into the surface plus `friction` along
/// `direction`, which is a unit vector, or zero if nothing moves.
inline ForcePoint
draggedForce(const StrikePoint& point, const std::array<float, 3>& direction, double friction) {
    ForcePoint force{.point = point, .direction = {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        force.direction[axis] = static_cast<float>(friction) * direction[axis] - point.normal[axis];
    return force;
}

} // namespace idiophone
