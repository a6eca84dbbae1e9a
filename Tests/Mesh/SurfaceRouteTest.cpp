#include "Mesh/SurfaceRoute.h"

#include "Geometry/ParametricMesh.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;

namespace {

const Eigen::Vector3d up(0, 0, 1);

double lengthOf(const std::vector<Eigen::Vector3d>& way) {
    double metres = 0;
    for (std::size_t i = 1; i < way.size(); ++i)
        metres += (way[i] - way[i - 1]).norm();
    return metres;
}

} // namespace

TEST_CASE("A route joins the vertices nearest to its points and is nearly straight") {
    const Mesh sheet = sheetMesh(0.4, 0.3, 400);
    const auto way = surfaceRoute(sheet, {-0.2, -0.15, 0}, {0.2, 0.15, 0}, up);
    REQUIRE(way.size() > 5);
    CHECK((way.front() - Eigen::Vector3d(-0.2, -0.15, 0)).norm() < 0.01);
    CHECK((way.back() - Eigen::Vector3d(0.2, 0.15, 0)).norm() < 0.01);
    CHECK(lengthOf(way) < 1.15 * 0.5);
}

TEST_CASE("A route around a ring is half its length and stays on the requested side") {
    const Mesh ring = torusMesh(0.1, 0.01, 80, 16);
    const auto way = surfaceRoute(ring, {-0.1, 0, 0.01}, {0.1, 0, 0.01}, up);
    const double half = std::numbers::pi * 0.1;
    CHECK(lengthOf(way) > 0.9 * half);
    CHECK(lengthOf(way) < 1.05 * half);
    for (const auto& place : way)
        CHECK(place.z() > 0);
}

TEST_CASE("If faces with the given direction do not connect two points, the route uses all faces") {
    // The faces of a ring that look along x are outside at one end and inside at the other.
    const Mesh ring = torusMesh(0.1, 0.01, 80, 16);
    const auto way = surfaceRoute(ring, {0.11, 0, 0}, {-0.09, 0, 0}, Eigen::Vector3d(1, 0, 0));
    REQUIRE(!way.empty());
    CHECK((way.front() - Eigen::Vector3d(0.11, 0, 0)).norm() < 0.005);
    CHECK((way.back() - Eigen::Vector3d(-0.09, 0, 0)).norm() < 0.005);
    CHECK(lengthOf(way) > 0.25);
}

TEST_CASE("There is no route between parts that do not touch") {
    const Mesh ball = icosphereMesh(0.05, 2);
    Mesh two;
    two.vertices.resize(2 * ball.vertexCount(), 3);
    two.vertices << ball.vertices, ball.vertices.rowwise() + Eigen::RowVector3d(1, 0, 0);
    two.faces.resize(2 * ball.faceCount(), 3);
    two.faces << ball.faces, ball.faces.array() + static_cast<int>(ball.vertexCount());
    CHECK(surfaceRoute(two, {0, 0, 0}, {1, 0, 0}, up).empty());
}
