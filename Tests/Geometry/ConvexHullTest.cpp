#include "Geometry/ConvexHull.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("A convex hull has the outer corners only, counter-clockwise") {
    using Points = std::vector<Eigen::Vector2f>;
    const auto hull =
        convexHull(Points{{0, 0}, {2, 0}, {1, 1}, {2, 2}, {0, 2}, {1, 0}, {0.5f, 1.5f}, {2, 2}});
    CHECK(hull == Points{{0, 0}, {2, 0}, {2, 2}, {0, 2}});
    CHECK(convexHull({}).empty());
    CHECK(convexHull(Points{{0, 0}, {1, 1}, {2, 2}}).size() == 2);
}
