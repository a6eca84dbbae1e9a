#include "Scene/LowestPoint.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <random>
#include <vector>

using namespace idiophone;

TEST_CASE("The lowest of many points is exact to the bit in every orientation") {
    std::mt19937 random(5);
    std::normal_distribution<double> number;
    std::vector<Eigen::Vector3d> points;
    for (int k = 0; k < 2000; ++k) {
        const Eigen::Vector3d point(number(random), number(random), number(random));
        points.push_back(k % 2 == 0 ? point.normalized() : 0.3 * point); // on and in a sphere
    }
    points.insert(points.end(), 100, points.front());
    const LowestPoint lowest(points);
    for (int round = 0; round < 200; ++round) {
        const Eigen::Isometry3d placed =
            Eigen::Translation3d(number(random), number(random), number(random)) *
            Eigen::Quaterniond(number(random), number(random), number(random), number(random))
                .normalized();
        double least = 1e300;
        for (const auto& point : points)
            least = std::min(least, (placed * point).z());
        REQUIRE(lowest.metres(placed) == least);
    }
}

TEST_CASE("A single point is the lowest") {
    const std::vector<Eigen::Vector3d> points{{1, 2, 3}};
    CHECK(LowestPoint(points).metres(Eigen::Isometry3d::Identity()) == 3);
}
