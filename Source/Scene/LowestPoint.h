// How low a body reaches, however it is turned.
#pragma once

#include "Geometry/BoxTree.h"

#include <Eigen/Geometry>
#include <span>

namespace idiophone {

/// Of fixed points, in the tree of boxes around them: a question looks at some of many.
class LowestPoint {
public:
    /// There is a point at least, and all are finite.
    explicit LowestPoint(std::span<const Eigen::Vector3d> points);

    /// The least z of the points when they are placed so: that of one of them, to the bit.
    double metres(const Eigen::Isometry3d& placed) const;

private:
    BoxTree tree;
    double slackMetres; ///< more than rounding moves the corner of a box
};

} // namespace idiophone
