#include "Geometry/PointCarrier.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>
#include <vector>

using namespace idiophone;
using Catch::Approx;
using Eigen::Vector3d;

namespace {

/// Checks that every point is a vertex with weight 1, that each row of weights sums to 1, and that
/// all faces have an area and look to `up`.
void check(const PointCarrier& carrier, const std::vector<Vector3d>& points, const Vector3d& up) {
    REQUIRE(carrier.weights.rows() == carrier.mesh.vertexCount());
    REQUIRE(carrier.weights.cols() == static_cast<Eigen::Index>(points.size()));
    CHECK(carrier.weights.minCoeff() >= 0);
    for (Eigen::Index row = 0; row < carrier.weights.rows(); ++row)
        CHECK(carrier.weights.row(row).sum() == Approx(1));
    for (std::size_t i = 0; i < points.size(); ++i) {
        bool found = false;
        for (Eigen::Index row = 0; row < carrier.mesh.vertexCount(); ++row)
            found =
                found || ((carrier.mesh.vertices.row(row).transpose() - points[i]).norm() < 1e-12 &&
                          carrier.weights(row, static_cast<Eigen::Index>(i)) == 1);
        CAPTURE(i);
        CHECK(found);
    }
    REQUIRE(carrier.mesh.faceCount() > 0);
    CHECK(faceAreas(carrier.mesh).minCoeff() > 0);
    const auto normals = vertexNormals(carrier.mesh);
    for (Eigen::Index row = 0; row < normals.rows(); ++row)
        CHECK(normals.row(row).dot(up) > 0.5);
}

} // namespace

TEST_CASE("A single point becomes a disc of 1 cm radius") {
    const std::vector<Vector3d> points{{0.1, 0.2, 0.3}};
    const auto carrier = carrierThrough(points);
    check(carrier, points, Vector3d::UnitZ());
    CHECK(boundingDiagonalMetres(carrier.mesh) == Approx(0.02 * std::sqrt(2.0)));
}

TEST_CASE("Points on a line become a strip, in any order and direction") {
    const std::vector<Vector3d> flat{{0.2, 0, 0}, {-0.1, 0, 0}, {0.05, 0, 0}};
    const auto carrier = carrierThrough(flat);
    check(carrier, flat, Vector3d::UnitZ());
    CHECK(faceAreas(carrier.mesh).sum() == Approx(0.3 * 0.06));
    const std::vector<Vector3d> upright{{0, 0, 0}, {0, 0, 1}};
    check(carrierThrough(upright), upright, Vector3d::UnitX());
}

TEST_CASE("Scattered points are triangulated without gap or overlap") {
    const std::vector<Vector3d> square{{0, 0, 0},   {1, 0, 0},     {0, 1, 0},    {1, 1, 0},
                                       {0.5, 0, 0}, {0.4, 0.6, 0}, {0.5, 0.5, 0}};
    const auto carrier = carrierThrough(square);
    check(carrier, square, Vector3d::UnitZ());
    CHECK(faceAreas(carrier.mesh).sum() == Approx(1));
    const std::vector<Vector3d> tilted{{0, 0, 0}, {1, 0, 0.1}, {0, 1, 0.2}, {1.1, 1, 0.3}};
    check(carrierThrough(tilted), tilted, Vector3d::UnitZ());
}

TEST_CASE("Radii become the rings of a closed disc") {
    for (const auto& radii : {std::vector<double>{0, 0.05, 0.1}, {0.02, 0.03}, {0.0}, {0.07}}) {
        const auto carrier = discOfRadii(radii);
        std::vector<Vector3d> points;
        for (const double radius : radii)
            points.emplace_back(radius, 0, 0);
        check(carrier, points, Vector3d::UnitZ());
    }
}

TEST_CASE(
    "On a mesh a point has full weight at its position, and equal distances give equal weights") {
    Mesh mesh;
    mesh.vertices.resize(4, 3);
    mesh.vertices << 0, 0, 0, 1, 0, 0, 0.5, 0, 0, 0.5, 2, 0;
    mesh.faces.resize(1, 3);
    mesh.faces << 0, 1, 3;
    const std::vector<Vector3d> points{{0, 0, 0}, {1, 0, 0}};
    const auto carrier = carriedBy(mesh, std::span<const Vector3d>(points));
    CHECK(carrier.weights(0, 0) == Approx(1));
    CHECK(carrier.weights(1, 1) == Approx(1));
    CHECK(carrier.weights(2, 0) == Approx(0.5));
    CHECK(carrier.weights(3, 1) == Approx(0.5));
}
