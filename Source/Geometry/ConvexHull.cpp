#include "Geometry/ConvexHull.h"

#include <CGAL/Simple_cartesian.h>
#include <CGAL/convex_hull_2.h>
#include <iterator>

namespace idiophone {

std::vector<Eigen::Vector2f> convexHull(std::span<const Eigen::Vector2f> points) {
    using Point = CGAL::Simple_cartesian<double>::Point_2;
    std::vector<Point> all, corners;
    all.reserve(points.size());
    for (const auto& point : points)
        all.emplace_back(point.x(), point.y());
    CGAL::convex_hull_2(all.begin(), all.end(), std::back_inserter(corners));
    std::vector<Eigen::Vector2f> hull;
    for (const auto& corner : corners)
        hull.emplace_back(static_cast<float>(corner.x()), static_cast<float>(corner.y()));
    return hull;
}

} // namespace idiophone
