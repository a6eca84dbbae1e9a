#include "Analysis/SpringMassModel.h"

#include "Analysis/Eigensolver.h"
#include "Geometry/ParametricMesh.h"
#include "Support/GeneratedMeshes.h"
#include "TestMaterials.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

constexpr double thickness = 0.005;

/// Returns the frequency of a thin spherical membrane of stiffness E t from the lower root W of W⁴
/// − (1+3ν+l(l+1))W² + (l−1)(l+2)(1−ν²) = 0.
double membraneFrequencyHz(int l, double radius, double stiffness, double massPerArea) {
    const double nu = 1.0 / 3, b = 1 + 3 * nu + l * (l + 1), c = (l - 1) * (l + 2) * (1 - nu * nu);
    const double w2 = (b - std::sqrt(b * b - 4 * c)) / 2;
    return std::sqrt(w2 * stiffness / (massPerArea * (1 - nu * nu))) / radius /
           (2 * std::numbers::pi);
}

Eigen::Index zeroModesOf(const Mesh& mesh, SpringStiffness stiffness) {
    const auto count =
        countModesBelow(springMassModel(mesh, referenceWood(), thickness, stiffness), 1);
    REQUIRE(count);
    return *count;
}

} // namespace

TEST_CASE("Zero modes of box surfaces and flat plates follow the coplanar-vertex law exactly") {
    const auto stiffness = GENERATE(SpringStiffness::literal, SpringStiffness::vanGelder);
    CHECK(zeroModesOf(boxMesh({0.4, 0.05, 0.02}, {20, 4, 2}), stiffness) == 164);
    CHECK(zeroModesOf(boxMesh({0.4, 0.05, 0.02}, {40, 6, 3}), stiffness) == 572);
    CHECK(zeroModesOf(gridPlateMesh(0.4, 0.05, 20, 4), stiffness) == 108);
    CHECK(zeroModesOf(gridPlateMesh(0.4, 0.05, 40, 8), stiffness) == 372);
}

TEST_CASE("An icosphere has six zero modes") {
    for (const int level : {2, 3, 4})
        CHECK(zeroModesOf(icosphereMesh(0.1, level), SpringStiffness::literal) == 6);
}

TEST_CASE("An icosphere's five l = 2 modes are equal within 1e-6 and within 3 % of theory") {
    const double radius = 0.1;
    const auto material = referenceWood();
    const auto stiffness = GENERATE(SpringStiffness::literal, SpringStiffness::vanGelder);
    const double membrane = material.youngsModulusPa * thickness *
                            (stiffness == SpringStiffness::literal ? 2 / std::sqrt(3.0) : 1.0);
    const double theory =
        membraneFrequencyHz(2, radius, membrane, material.densityKgPerM3 * thickness);
    const int level = GENERATE(3, 4);
    const auto modes =
        solveModes(springMassModel(icosphereMesh(radius, level), material, thickness, stiffness),
                   {.lowestHz = 20, .highestHz = 1.1 * theory});
    REQUIRE(modes);
    REQUIRE(modes->eigenvalues.size() >= 5);
    CHECK(modes->zeroModes == 6);
    const auto f = frequenciesHz(modes->eigenvalues);
    CHECK(f(4) / f(0) - 1 < 1e-6);
    CHECK(f(5 % f.size()) / f(0) - 1 > (f.size() > 5 ? 0.05 : -1));
    CHECK_THAT(f(0), WithinRel(theory, 0.03));
}

TEST_CASE("An icosphere's l = 4 modes are within 10 % of membrane theory") {
    const auto material = referenceWood();
    const double theory = membraneFrequencyHz(4, 0.1, material.youngsModulusPa * thickness,
                                              material.densityKgPerM3 * thickness);
    const auto modes = solveModes(
        springMassModel(icosphereMesh(0.1, 3), material, thickness, SpringStiffness::vanGelder),
        {.lowestHz = 20, .highestHz = 1.2 * theory});
    REQUIRE(modes);
    REQUIRE(modes->eigenvalues.size() >= 5 + 7 + 9);
    const auto f = frequenciesHz(modes->eigenvalues);
    for (int mode = 12; mode < 21; ++mode)
        CHECK_THAT(f(mode), WithinRel(theory, 0.10));
}

TEST_CASE("The masses sum to density times thickness times area") {
    const auto mesh = boxMesh({0.4, 0.05, 0.02}, {20, 4, 2});
    const auto model = springMassModel(mesh, referenceWood(), thickness, SpringStiffness::literal);
    CHECK_THAT(model.mass.sum() / 3, WithinRel(1000 * thickness * faceAreas(mesh).sum(), 1e-12));
}
