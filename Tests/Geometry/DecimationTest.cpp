#include "Geometry/Decimation.h"

#include "Geometry/MeshCheck.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/TestMeshes.h"
#include "Mesh/SurfaceQuery.h"
#include "Support/GeneratedMeshes.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using Catch::Matchers::ContainsSubstring;

namespace {

/// A ball with the noise of a scan.
Mesh scan(int level, double noiseMetres) {
    auto mesh = icosphereMesh(0.1, level);
    std::mt19937 random(7);
    for (auto vertex : mesh.vertices.rowwise())
        vertex *= 1 + noiseMetres / 0.1 * (static_cast<double>(random() % 2001) / 1000 - 1);
    return mesh;
}

} // namespace

TEST_CASE("A scan is decimated to its budget within a thousandth of its size") {
    const auto ball = scan(6, 2e-5);
    const auto decimated = decimate(ball, 1000);
    REQUIRE(decimated);
    CHECK(decimated->vertexCount() == 1000);
    CHECK(isOrientedManifold(*decimated));
    CHECK(checkMesh(*decimated).isSolid());
    CHECK(signedVolumeM3(*decimated) == Approx(signedVolumeM3(ball)).epsilon(0.005));
    const SurfaceQuery surface(*decimated);
    double greatest = 0;
    for (const auto& vertex : ball.vertices.rowwise())
        greatest = std::max(greatest, surface.nearestPoint(vertex.transpose()).distanceMetres);
    CHECK(greatest < 1e-3);
}

TEST_CASE("A finely divided box is decimated to its eight corners") {
    const auto decimated = decimate(boxMesh({0.3, 0.2, 0.1}, {30, 20, 10}), 8);
    REQUIRE(decimated);
    CHECK(decimated->vertexCount() == 8);
    CHECK(signedVolumeM3(*decimated) == Approx(0.006).epsilon(1e-6));
}

TEST_CASE("An open sheet keeps its area when decimated") {
    const auto decimated = decimate(gridPlateMesh(0.4, 0.1, 80, 20), 60);
    REQUIRE(decimated);
    CHECK(isOrientedManifold(*decimated));
    CHECK(faceAreas(*decimated).sum() == Approx(0.04).epsilon(1e-6));
}

TEST_CASE("A mesh within its budget stays as it is") {
    const auto ball = icosphereMesh(0.1, 2);
    const auto same = decimate(ball, 162);
    REQUIRE(same);
    CHECK(same->faceCount() == ball.faceCount());
    CHECK((same->vertices - ball.vertices).cwiseAbs().maxCoeff() < 1e-15);
}

TEST_CASE("Decimation to a budget below the topology's needs fails and names the required number") {
    std::mt19937 random(9);
    Mesh triangles{Eigen::MatrixXd::Random(300, 3), Eigen::MatrixXi(100, 3)};
    for (int i = 0; i < 300; ++i)
        triangles.faces(i / 3, i % 3) = i;
    const auto refused = decimate(triangles, 50);
    REQUIRE_FALSE(refused);
    CHECK_THAT(refused.error().message, ContainsSubstring("50 vertices"));
    CHECK_THAT(decimate(icosphereMesh(1, 2), 3).error().message, ContainsSubstring("4 vertices"));
    CHECK_THAT(decimate({}, 100).error().message, ContainsSubstring("no faces"));
}

TEST_CASE("Decimation fails if too many faces meet in one vertex") {
    CHECK(decimate(fanMesh(500), 400));
    CHECK_THAT(decimate(fanMesh(2000), 400).error().message,
               ContainsSubstring("too many of its faces meet in one vertex"));
}

TEST_CASE("A decimation reports its progress and can be cancelled") {
    const auto ball = scan(5, 0);
    std::vector<double> told;
    std::atomic<bool> cancelled = false;
    WorkControl control{.progress = [&](double f, std::string_view) { told.push_back(f); },
                        .cancelled = &cancelled};
    REQUIRE(decimate(ball, 200, control));
    CHECK(std::ranges::is_sorted(told));
    CHECK(told.size() > 10);
    CHECK(told.back() == 1);
    control.progress = [&](double f, std::string_view) { cancelled = f > 0.5; };
    const auto stopped = decimate(ball, 200, control);
    REQUIRE_FALSE(stopped);
    CHECK(stopped.error().message == cancelledMessage);
}
