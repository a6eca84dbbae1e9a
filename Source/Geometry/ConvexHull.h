// The convex hull of points in the plane.
#pragma once

#include <Eigen/Core>
#include <span>
#include <vector>

namespace idiophone {

/// Returns the corners of the hull, counter-clockwise where y points up. The points are finite.
/// Equal points count once: for points on a line there are two corners at most.
std::vector<Eigen::Vector2f> convexHull(std::span<const Eigen::Vector2f> points);

} // namespace idiophone
