#include "Geometry/SelfIntersection.h"

#include "Geometry/ParametricMesh.h"
#include "Geometry/TestMeshes.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("Good surfaces do not intersect themselves, even flat or finely divided ones") {
    for (const auto& mesh :
         {icosphereMesh(0.1, 4), boxMesh({1, 1, 1}, {5, 5, 5}), torusMesh(0.1, 0.01, 40, 8),
          sheetMesh(1, 0.1, 400), bowl(0.1, 0.002, 12), moebiusStrip(40, 4), book(7),
          joined(icosphereMesh(1, 2), icosphereMesh(0.9, 2))})
        CHECK(intersectsItself(mesh) == false);
}

TEST_CASE("Surfaces that cross, touch or fold onto themselves intersect") {
    const auto ball = icosphereMesh(1, 3);
    CHECK(intersectsItself(joined(ball, moved(ball, {0.5, 0, 0}))) == true);
    const auto cube = boxMesh({1, 1, 1}, {2, 2, 2});
    CHECK(intersectsItself(joined(cube, moved(cube, {1, 0, 0}))) == true);
    CHECK(intersectsItself(kleinBottle(60, 40)) == true);
    Mesh folded{Eigen::MatrixXd(4, 3), Eigen::MatrixXi(2, 3)};
    folded.vertices << 0, 0, 0, 1, 0, 0, 0.3, 1, 0, 0.6, 0.7, 0;
    folded.faces << 0, 1, 2, 1, 0, 3;
    CHECK(intersectsItself(folded) == true);
    folded.vertices(3, 1) = -0.7;
    CHECK(intersectsItself(folded) == false);
}

TEST_CASE("Two faces with a common vertex intersect only if one passes through the other") {
    Mesh mesh{Eigen::MatrixXd(5, 3), Eigen::MatrixXi(2, 3)};
    mesh.vertices << 0, 0, 0, 1, 0, 0, 0, 1, 0, 0.5, 0.2, 1, 0.5, 0.2, -1;
    mesh.faces << 0, 1, 2, 0, 3, 4;
    CHECK(intersectsItself(mesh) == true);
    mesh.vertices.row(4) << 0.5, 0.2, 0.5;
    CHECK(intersectsItself(mesh) == false);
}

TEST_CASE("A ball of 327,680 triangles is checked, and a dent through it is found") {
    auto ball = icosphereMesh(1, 7);
    CHECK(intersectsItself(ball) == false);
    ball.vertices.row(100) *= -1.2;
    CHECK(intersectsItself(ball) == true);
}

TEST_CASE("Slivers with overlapping boxes give no result, in bounded time") {
    constexpr int count = 40000; // 800 million pairs of boxes
    Mesh slivers{Eigen::MatrixXd(3 * count, 3), Eigen::MatrixXi(count, 3)};
    for (int i = 0; i < count; ++i) {
        const double angle = 1e-3 * i;
        const Eigen::RowVector3d side(std::cos(angle), -std::cos(angle), std::sin(angle));
        slivers.vertices.row(3 * i) = 0.01 * (1 + 1e-3 * i) * side;
        slivers.vertices.row(3 * i + 1) =
            Eigen::RowVector3d(1, 1, 1) + 0.01 * (1 + 1e-3 * i) * side;
        slivers.vertices.row(3 * i + 2) = 0.01 * (1 + 1e-3 * i + 1e-9) * side;
        slivers.faces.row(i) << 3 * i, 3 * i + 1, 3 * i + 2;
    }
    CHECK(intersectsItself(slivers) == std::nullopt);
}

TEST_CASE("The search for intersections can be cancelled") {
    const std::atomic<bool> cancelled = true;
    CHECK(intersectsItself(icosphereMesh(1, 6), &cancelled) == std::nullopt);
}
