#include "Analysis/SolidShell.h"

#include "Analysis/Eigensolver.h"
#include "Geometry/LatheMesh.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

TEST_CASE("The wall of a sheet is a solid with the sheet's area times its thickness") {
    const auto sheet = sheetMesh(0.3, 0.2, 300);
    const auto body =
        solidShell(sheet, Eigen::VectorXd::Constant(sheet.vertexCount(), 0.004), referenceWood());
    CHECK(checkMesh(body.surface).isSolid());
    CHECK_THAT(signedVolumeM3(body.surface), WithinRel(0.3 * 0.2 * 0.004, 1e-9));
    CHECK(body.surface.vertexCount() == 2 * sheet.vertexCount());
    CHECK(body.pointsMetres.rows() * 3 == body.model.mass.rows());
}

TEST_CASE("The wall follows a varying thickness") {
    const auto disc = discMesh(0.1, 12);
    // A flat double cone, 2 mm in the middle and 1 mm at the rim: its volume is exact.
    const Eigen::VectorXd thickness = 0.002 - 0.001 * disc.vertices.rowwise().norm().array() / 0.1;
    const auto body = solidShell(disc, thickness, referenceWood());
    const double cone = std::numbers::pi * 0.01 * (0.001 + 0.001 / 3);
    CHECK_THAT(signedVolumeM3(body.surface), WithinRel(cone, 0.01));
}

TEST_CASE("A turned disc has Kirchhoff's modes within 1 %, in pairs equal within 0.01 %") {
    constexpr double radius = 0.1, thickness = 0.002;
    const auto disc = latheMesh({{0, 0, thickness}, {radius, 0, thickness}}, 0.009);
    const auto material = referenceWood(0.3);
    const auto body = solidShell(disc.mesh, disc.thicknessMetres, material);
    const auto modes = solveModes(body.model, {.lowestHz = 20, .highestHz = 1100});
    REQUIRE(modes);
    CHECK(modes->zeroModes == 6);
    const Eigen::VectorXd found = frequenciesHz(modes->eigenvalues);
    const double unitHz = thickness * std::sqrt(20e9 / (12 * (1 - 0.09) * 1000)) /
                          (2 * std::numbers::pi * radius * radius);
    // ω R² √(ρh/D) of the free disc, ν = 0.3: (2,0), (0,1), (3,0), (1,1), (4,0).
    const double theory[] = {5.3583,  5.3583,  9.0031,  12.4390, 12.4390,
                             20.4746, 20.4746, 21.8352, 21.8352};
    REQUIRE(found.size() >= std::ssize(theory));
    for (Eigen::Index mode = 0; mode < std::ssize(theory); ++mode)
        CHECK_THAT(found(mode), WithinRel(theory[mode] * unitHz, 0.01));
    for (const Eigen::Index first : {0, 3, 5, 7})
        CHECK_THAT(found(first + 1), WithinRel(found(first), 1e-4));
}
