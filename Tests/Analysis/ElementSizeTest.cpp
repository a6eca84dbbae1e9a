#include "Analysis/ElementSize.h"

#include "Analysis/Eigensolver.h"
#include "Analysis/QuadraticTetrahedra.h"
#include "Analysis/TetMesh.h"
#include "Geometry/MeshCheck.h"
#include "Geometry/ParametricMesh.h"
#include "SolvedBody.h"
#include "Support/GeneratedMeshes.h"
#include "TestMaterials.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

TEST_CASE(
    "The shortest wavelength is a plate's at low frequencies and a surface wave's at high ones") {
    const auto law = elasticLaw(referenceWood(0.3));
    const double h = 0.01;
    const double bending = std::sqrt(2 * std::numbers::pi * h / 10) * std::pow(20e9 / 12e3, 0.25);
    CHECK_THAT(shortestWavelengthMetres(law, 1000, 10, h), WithinRel(bending, 0.01));
    const double shear = std::sqrt(20e9 / 2.6 / 1000) / 5e6;
    CHECK_THAT(shortestWavelengthMetres(law, 1000, 5e6, h),
               WithinRel(std::sqrt(5.0 / 6) * shear, 0.01));
}

TEST_CASE("Elements never grow when the band grows or the wall thins") {
    const auto law = elasticLaw(referenceWood(0.3));
    for (double wall = 1e-4; wall < 1; wall *= 1.5)
        for (double hz = 50; hz < 1e5; hz *= 1.5) {
            const double edge = targetEdgeMetres(law, 1000, hz, wall);
            REQUIRE(targetEdgeMetres(law, 1000, 1.5 * hz, wall) <= edge);
            REQUIRE(targetEdgeMetres(law, 1000, hz, wall / 1.5) <= edge);
            REQUIRE(edge <= 4 * wall);
        }
}

TEST_CASE("A block meshed at the target edge has its modes within 1 % of a finer model") {
    // Counts modes: every mode of the finer model below f must lie below 1.01 f in the coarser
    // model.
    const double maxHz = 4500;
    const auto law = elasticLaw(referenceWood(0.3));
    const Eigen::Vector3d size(1, 0.7, 0.5);
    const auto modelAt = [&](double edge) {
        const Eigen::Vector3i segments = (size / edge).array().round().cast<int>();
        const auto mesh = tetrahedralise(boxMesh(size, segments), {.targetEdgeMetres = edge});
        REQUIRE(mesh);
        return quadraticTetrahedra(*mesh, law, 1000);
    };
    const double edge =
        targetEdgeMetres(law, 1000, maxHz, checkMesh(boxMesh(size, {1, 1, 1})).meanThicknessMetres);
    const auto coarse = modelAt(edge), fine = modelAt(edge / 1.4);
    for (const double hz : {0.6 * maxHz, 0.8 * maxHz, maxHz}) {
        const auto inFine = countModesBelow(fine, hz),
                   inCoarse = countModesBelow(coarse, 1.01 * hz);
        REQUIRE(inFine);
        REQUIRE(inCoarse);
        CHECK(*inFine > 3);
        CHECK(*inCoarse >= *inFine);
    }
}

TEST_CASE("A plate meshed at the target edge has all modes of its band within 1.5 %") {
    const double thickness = 0.06;
    const auto law = elasticLaw(referenceWood(0.3));
    const double unit =
        std::sqrt(20e9 * thickness * thickness / (12e3 * (1 - 0.09))) / (2 * std::numbers::pi);
    const double maxHz = 62 * unit;
    const auto solvedAt = [&](double edge) {
        const int vertices = static_cast<int>(2 / (std::sqrt(3.0) * edge * edge));
        return frequenciesHz(solvedSolid(extrudedMesh(sheetMesh(1, 1, vertices), thickness), law,
                                         1000, edge, {.lowestHz = unit, .highestHz = 1.1 * maxHz}));
    };
    const double edge = targetEdgeMetres(law, 1000, maxHz, thickness);
    const auto coarse = solvedAt(edge), fine = solvedAt(edge / 1.6);
    REQUIRE(coarse.size() >= 6);
    REQUIRE(fine.size() >= coarse.size());
    for (std::size_t i = 0; i < coarse.size() && fine[i] < maxHz; ++i)
        CHECK_THAT(coarse[i], WithinRel(fine[i], 0.015));
}
