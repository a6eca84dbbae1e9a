// The box around a modal object, whose coordinates from −1 to 1 are those of strike paths.
#pragma once

#include "Object/ModalObject.h"

#include <array>
#include <cstddef>

namespace idiophone {

struct ObjectBox {
    std::array<double, 3> centreMetres{};
    std::array<double, 3> halfExtentMetres{}; ///< 0 along the normal of a flat sheet

    explicit ObjectBox(const ModalObject& object); ///< which has a vertex

    std::array<double, 3> at(const std::array<double, 3>& relative) const;
    /// −1 to 1 each, what lies outside at the box's side; 0 where the box has no extent.
    std::array<double, 3> relative(const std::array<double, 3>& pointMetres) const;
    /// The box's reach from its middle along a unit vector, weighted by its sides: Σ |d| h.
    double reachMetres(const std::array<double, 3>& direction) const;
    std::size_t longestAxis() const; ///< 0, 1 or 2
};

} // namespace idiophone
