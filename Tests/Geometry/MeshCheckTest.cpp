#include "Geometry/MeshCheck.h"

#include "Geometry/MeshRepair.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/TestMeshes.h"
#include "Support/GeneratedMeshes.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using Catch::Matchers::WithinRel;

TEST_CASE("Bars, cubes, balls, rings and rods are thick solids") {
    const Mesh rod = boxMesh({1, 0.01, 0.01}, {100, 1, 1});
    for (const auto& mesh : {boxMesh({0.35, 0.05, 0.02}, {35, 5, 2}), boxMesh({1, 1, 1}, {4, 4, 4}),
                             icosphereMesh(0.05, 4), torusMesh(0.1, 0.01, 60, 12), rod}) {
        const auto check = checkMesh(mesh);
        CHECK(check.isSolid());
        CHECK_FALSE(check.isThin());
        CHECK(check.slenderness < 45);
    }
}

TEST_CASE("A bowl with a 2 mm wall and a plate of 0.3 x 0.2 x 0.003 are thin solids") {
    const auto bowlCheck = checkMesh(bowl(0.1, 0.002, 40));
    CHECK(bowlCheck.isSolid());
    CHECK(bowlCheck.isThin());
    CHECK(bowlCheck.meanThicknessMetres == Approx(0.002).epsilon(0.03));
    const auto plateCheck = checkMesh(boxMesh({0.3, 0.2, 0.003}, {30, 20, 1}));
    CHECK(plateCheck.isSolid());
    CHECK(plateCheck.isThin());
    CHECK(plateCheck.slenderness == Approx(119.8).epsilon(0.01));
}

TEST_CASE("A hollow ball is thin although each of its surfaces alone is thick") {
    const auto repaired = repairMesh(joined(icosphereMesh(0.1, 4), icosphereMesh(0.098, 4)));
    const auto check = checkMesh(repaired->mesh);
    CHECK(check.isSolid());
    CHECK(check.isThin());
    CHECK(check.meanThicknessMetres == Approx(0.002).epsilon(0.01));
}

TEST_CASE("Open sheets and hemispheres are not solids") {
    for (const auto& mesh :
         {sheetMesh(0.4, 0.05, 300), openHemisphere(0.1, 10), hoopMesh(0.1, 0.02, 40, 4)}) {
        const auto check = checkMesh(mesh);
        CHECK_FALSE(check.isClosed);
        CHECK_FALSE(check.isSolid());
        CHECK(check.isThin());
        CHECK(check.boundaryEdges > 0);
        CHECK(check.intersectsItself == false);
    }
}

TEST_CASE("Volume, area and mean thickness match their closed forms") {
    const auto ball = checkMesh(icosphereMesh(0.1, 5));
    CHECK(ball.volumeM3 == Approx(4 * std::numbers::pi / 3 * 1e-3).epsilon(0.002));
    CHECK(ball.areaM2 == Approx(4 * std::numbers::pi * 1e-2).epsilon(0.002));
    CHECK(ball.meanThicknessMetres == Approx(0.2 / 3).epsilon(0.002));
    CHECK(ball.slenderness == Approx(3 * std::sqrt(std::numbers::pi)).epsilon(0.002));
    const auto box = checkMesh(boxMesh({1, 2, 3}, {2, 2, 2}));
    CHECK(box.volumeM3 == Approx(6));
    CHECK(box.areaM2 == Approx(22));
}

TEST_CASE("The check does not depend on size or position") {
    for (const double scale : {1e-4, 1.0, 1e4}) {
        auto mesh = bowl(0.1, 0.002, 12);
        mesh.vertices *= scale;
        mesh.vertices.rowwise() += Eigen::RowVector3d(5, -3, 2) * scale;
        const auto check = checkMesh(mesh);
        CHECK(check.isSolid());
        CHECK(check.slenderness == Approx(checkMesh(bowl(0.1, 0.002, 12)).slenderness));
    }
}

TEST_CASE("Meshes with inconsistent faces or edges of many faces are not solids") {
    auto mesh = icosphereMesh(1, 2);
    std::swap(mesh.faces(5, 0), mesh.faces(5, 1));
    CHECK(checkMesh(mesh).isClosed);
    CHECK_FALSE(checkMesh(mesh).isOriented);
    CHECK_FALSE(checkMesh(mesh).isSolid());
    CHECK(checkMesh(book(3)).nonManifoldEdges == 1);
    CHECK_FALSE(checkMesh(insideOut(icosphereMesh(1, 2))).isSolid());
}

TEST_CASE(
    "Mean thickness is that of a plate or a hollow sphere's wall, and a third of a cube's side") {
    CHECK_THAT(checkMesh(extrudedMesh(sheetMesh(1, 1, 100), 0.01)).meanThicknessMetres,
               WithinRel(0.01, 0.03));
    CHECK_THAT(checkMesh(hollowSphereMesh(1, 0.02, 3)).meanThicknessMetres, WithinRel(0.02, 0.02));
    CHECK_THAT(checkMesh(boxMesh({1, 1, 1}, {1, 1, 1})).meanThicknessMetres,
               WithinRel(1.0 / 3, 1e-12));
}
