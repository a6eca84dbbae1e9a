#include "Geometry/PolygonTriangles.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>
#include <random>

using namespace idiophone;

namespace {

Eigen::MatrixX3d flat(std::initializer_list<std::array<double, 2>> places) {
    Eigen::MatrixX3d polygon(static_cast<Eigen::Index>(places.size()), 3);
    Eigen::Index row = 0;
    for (const auto& [x, y] : places)
        polygon.row(row++) << x, y, 0;
    return polygon;
}

Eigen::MatrixX3d startingAt(const Eigen::MatrixX3d& polygon, Eigen::Index first) {
    Eigen::MatrixX3d result(polygon.rows(), 3);
    result << polygon.bottomRows(polygon.rows() - first), polygon.topRows(first);
    return result;
}

Eigen::RowVector3d areaVector(const Eigen::MatrixX3d& polygon, const std::array<int, 3>& corners) {
    const Eigen::RowVector3d origin = polygon.row(corners[0]);
    return (polygon.row(corners[1]) - origin).cross(polygon.row(corners[2]) - origin) / 2;
}

/// Returns the sum of the triangles' areas, in m².
double areaOf(const Eigen::MatrixX3d& polygon) {
    double sum = 0;
    for (const auto& corners : trianglesOf(polygon).corners)
        sum += areaVector(polygon, corners).norm();
    return sum;
}

const Eigen::MatrixX3d letterL = flat({{0, 0}, {5, 0}, {5, 1}, {1, 1}, {1, 4}, {0, 4}});
const Eigen::MatrixX3d arrow = flat({{0, 0}, {2, 1}, {0, 2}, {1, 1}});
const Eigen::MatrixX3d comb = flat({{0, 0},
                                    {5, 0},
                                    {5, 3},
                                    {4, 3},
                                    {4, 1},
                                    {3, 1},
                                    {3, 3},
                                    {2, 3},
                                    {2, 1},
                                    {1, 1},
                                    {1, 3},
                                    {0, 3}});

} // namespace

TEST_CASE("A concave polygon is filled inside its outline, whichever corner is first") {
    const std::pair<Eigen::MatrixX3d, double> polygons[] = {{letterL, 8}, {arrow, 1}, {comb, 11}};
    const Eigen::Matrix3d turned =
        Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
    for (const auto& [polygon, area] : polygons)
        for (Eigen::Index first = 0; first < polygon.rows(); ++first)
            for (const auto& placed : {polygon, Eigen::MatrixX3d(polygon * turned),
                                       Eigen::MatrixX3d(polygon.colwise().reverse())}) {
                const auto started = startingAt(placed, first);
                const auto triangles = trianglesOf(started);
                CHECK_FALSE(triangles.isGuess);
                CHECK(triangles.corners.size() == static_cast<std::size_t>(polygon.rows() - 2));
                CHECK(std::abs(areaOf(started) - area) < 1e-9);
                // The triangles look to the polygon's side.
                const Eigen::RowVector3d side = areaVector(started, triangles.corners.front());
                for (const auto& corners : triangles.corners)
                    CHECK(areaVector(started, corners).dot(side) > 0);
            }
}

TEST_CASE("A polygon that is not quite flat is filled as seen across its best plane") {
    std::mt19937 random(1);
    for (int round = 0; round < 50; ++round) {
        auto bent = comb;
        for (Eigen::Index corner = 0; corner < bent.rows(); ++corner)
            bent(corner, 2) = 0.6 * static_cast<double>(random() % 1000) / 1000;
        const auto triangles = trianglesOf(startingAt(bent, round % bent.rows()));
        REQUIRE_FALSE(triangles.isGuess);
        REQUIRE(triangles.corners.size() == 10);
        double seen = 0; // from above
        for (const auto& corners : triangles.corners)
            seen += std::abs(areaVector(startingAt(bent, round % bent.rows()), corners).z());
        CHECK(std::abs(seen - 11) < 0.2);
    }
}

TEST_CASE("A convex polygon stays a fan from its first corner") {
    Eigen::MatrixX3d polygon(7, 3);
    for (Eigen::Index corner = 0; corner < 7; ++corner)
        polygon.row(corner) << std::cos(0.9 * static_cast<double>(corner)),
            std::sin(0.9 * static_cast<double>(corner)), 0.01 * static_cast<double>(corner % 3);
    const auto triangles = trianglesOf(polygon);
    REQUIRE(triangles.corners.size() == 5);
    for (int k = 0; k < 5; ++k)
        CHECK(triangles.corners[static_cast<std::size_t>(k)] == std::array{0, k + 1, k + 2});
}

TEST_CASE("Corners on a straight side give no triangle without area") {
    const auto polygon = flat({{0, 0}, {1, 0}, {2, 0}, {2, 1}, {2, 2}, {0, 2}});
    const auto triangles = trianglesOf(polygon);
    CHECK(triangles.corners.size() == 4);
    for (const auto& corners : triangles.corners)
        CHECK(areaVector(polygon, corners).norm() > 0.1);
    CHECK_FALSE(trianglesOf(flat({{0, 0}, {1, 0}, {2, 0}, {3, 0}})).isGuess);
}

TEST_CASE("A polygon with a cut to its hole leaves the hole open") {
    // The outline runs along the cut from (0, 0) to (1, 1) twice.
    const auto frame =
        flat({{0, 0}, {4, 0}, {4, 4}, {0, 4}, {0, 0}, {1, 1}, {1, 3}, {3, 3}, {3, 1}, {1, 1}});
    for (Eigen::Index first = 0; first < frame.rows(); ++first)
        CHECK(std::abs(areaOf(startingAt(frame, first)) - 12) < 1e-9);
}

TEST_CASE("A polygon that crosses itself is reported, and still has triangles") {
    for (const auto& crossed : {flat({{0, 0}, {2, 2}, {2, 0}, {0, 2}}),
                                flat({{0, 0}, {4, 4}, {4, 0}, {0, 3}, {-1, 1}})}) {
        const auto triangles = trianglesOf(crossed);
        CHECK(triangles.isGuess);
        CHECK(triangles.corners.size() == static_cast<std::size_t>(crossed.rows() - 2));
    }
}

TEST_CASE("A polygon of twenty thousand corners is filled") {
    Eigen::MatrixX3d star(20000, 3);
    for (Eigen::Index corner = 0; corner < star.rows(); ++corner) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(corner) / 20000;
        const double radius = corner % 2 == 0 ? 1 : 0.99;
        star.row(corner) << radius * std::cos(angle), radius * std::sin(angle), 0;
    }
    const auto triangles = trianglesOf(star);
    CHECK_FALSE(triangles.isGuess);
    CHECK(triangles.corners.size() == 19998);
}
