#include "Geometry/SweptMesh.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Matchers::WithinRel;
using Eigen::Vector3d;

namespace {

constexpr double pi = std::numbers::pi, radius = 0.005;
constexpr int sides = 12;

double lengthOf(const std::vector<Vector3d>& path) {
    double length = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        length += (path[i] - path[i - 1]).norm();
    return length;
}

double sectionM2() {
    return sides / 2.0 * std::sin(2 * pi / sides) * radius * radius;
}

} // namespace

TEST_CASE("A straight rod is a closed prism of its section and length") {
    const Mesh rod = rodMesh(roundedPath({{0, 0, 0}, {0.1, 0, 0}}, 0, 0.01), radius, sides);
    CHECK(isClosed(uniqueEdges(rod)));
    CHECK(rod.vertexCount() == 11 * sides + 2);
    CHECK_THAT(signedVolumeM3(rod), WithinRel(sectionM2() * 0.1, 1e-9));
}

TEST_CASE("A bent rod encloses its section times the length of its path") {
    const auto path = roundedPath({{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.08, 0.03}}, 0.02, 0.002);
    const Mesh rod = rodMesh(path, radius, sides);
    CHECK(isClosed(uniqueEdges(rod)));
    CHECK_THAT(signedVolumeM3(rod), WithinRel(sectionM2() * lengthOf(path), 0.005));
}

TEST_CASE("A rounded corner is an arc between two tangents") {
    const auto path = roundedPath({{0, 0, 0}, {0.1, 0, 0}, {0.1, 0.1, 0}}, 0.02, 0.001);
    CHECK((path.front() - Vector3d(0, 0, 0)).norm() < 1e-12);
    CHECK((path.back() - Vector3d(0.1, 0.1, 0)).norm() < 1e-12);
    CHECK_THAT(lengthOf(path), WithinRel(0.16 + pi / 2 * 0.02, 1e-3));
    for (const auto& point : path)
        if (point.x() > 0.0801 && point.y() < 0.0199)
            CHECK_THAT((point - Vector3d(0.08, 0.02, 0)).norm(), WithinRel(0.02, 1e-6));
}
