// The bounding box of a modal object; strike paths use its coordinates, −1 to 1.
#pragma once

#include "Object/ModalObject.h"

#include <array>
#include <cstddef>

namespace idiophone {

struct ObjectBox {
    std::array<double, 3> centreMetres{};
    std::array<double, 3> halfExtentMetres{}; ///< 0 along the normal of a flat sheet

    explicit ObjectBox(const ModalObject& object); ///< needs at least one vertex

    std::array<double, 3> at(const std::array<double, 3>& relative) const;
    /// Returns −1 to 1 for each axis, clamped to the box; 0 on an axis where the box has no extent.
    std::array<double, 3> relative(const std::array<double, 3>& pointMetres) const;
    /// Returns the box's reach from its middle along a unit vector, weighted by its sides: Σ |d| h.
    double reachMetres(const std::array<double, 3>& direction) const;
    std::size_t longestAxis() const; ///< 0, 1 or 2
};

} // namespace idiophone
