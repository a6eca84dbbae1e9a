// Finds how low a body reaches in any orientation.
#pragma once

#include "Geometry/BoxTree.h"

#include <Eigen/Geometry>
#include <span>

namespace idiophone {

/// Keeps fixed points in a tree of boxes, so that a query looks at few of them.
class LowestPoint {
public:
    /// Expects at least one point, and finite coordinates.
    explicit LowestPoint(std::span<const Eigen::Vector3d> points);

    /// Returns the minimum z of the placed points. Equals the z of one point to the bit.
    double metres(const Eigen::Isometry3d& placed) const;

private:
    BoxTree tree;
    double slackMetres; ///< larger than the rounding error of a box corner
};

} // namespace idiophone
