#include "Analysis/TwoLayerShell.h"

#include "Analysis/Eigensolver.h"
#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

/// Returns the frequencies of modes that bend along x only: the normal displacement does not change
/// sign across the width.
std::vector<double> bendingFrequenciesHz(const Mesh& mesh, const Modes& modes) {
    const auto shapes = midSurfaceShapes(modes.shapes);
    std::vector<double> result;
    for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode) {
        double normal = 0, all = 0, twist = 0;
        for (Eigen::Index v = 0; v < mesh.vertexCount(); ++v) {
            const Eigen::RowVector3d mirrored(mesh.vertices(v, 0), -mesh.vertices(v, 1), 0);
            Eigen::Index image = 0;
            (mesh.vertices.rowwise() - mirrored).rowwise().squaredNorm().minCoeff(&image);
            const double z = shapes(3 * v + 2, mode);
            normal += z * z;
            all += shapes.col(mode).segment<3>(3 * v).squaredNorm();
            twist += std::pow(z - shapes(3 * image + 2, mode), 2) / 4;
        }
        if (normal > 0.5 * all && twist < 0.1 * normal)
            result.push_back(frequenciesHz(modes.eigenvalues)(mode));
    }
    return result;
}

} // namespace

TEST_CASE("The two-layer bar's first four bending modes are within 0.5 % of Timoshenko") {
    // 0.4 × 0.05 × 0.02 m, Y 20 GPa, ρ 1000, ν 0.25, Cowper's κ.
    constexpr std::array timoshenkoHz{569.6, 1545.4, 2963.4, 4765.2};
    const auto mesh = sheetMesh(0.4, 0.05, 600);
    CHECK(std::abs(mesh.vertexCount() - 600) < 100);
    const auto modes = solveModes(twoLayerShell(mesh, referenceWood(0.25), 0.02),
                                  {.lowestHz = 20, .highestHz = 6000});
    REQUIRE(modes);
    CHECK(modes->zeroModes == 6);
    const auto bending = bendingFrequenciesHz(mesh, *modes);
    REQUIRE(bending.size() >= timoshenkoHz.size());
    for (std::size_t i = 0; i < timoshenkoHz.size(); ++i)
        CHECK_THAT(bending[i], WithinRel(timoshenkoHz[i], 0.005));
}

TEST_CASE("The first eight modes of a free square two-layer plate are within 3 % of theory") {
    // A completely free square plate, ν = 1/3, ω a² √(ρ h/D).
    constexpr std::array theory{13.1655, 19.2200, 24.4243, 34.2267,
                                34.2267, 60.9304, 60.9304, 62.7477};
    const double side = 0.3, thickness = GENERATE(0.001, 0.003);
    const auto material = referenceWood(1.0 / 3);
    const double rigidity =
        material.youngsModulusPa * std::pow(thickness, 3) / (12 * (1 - 1.0 / 9));
    const double unit = std::sqrt(rigidity / (material.densityKgPerM3 * thickness)) /
                        (side * side) / (2 * std::numbers::pi);
    const auto modes = solveModes(twoLayerShell(sheetMesh(side, side, 1074), material, thickness),
                                  {.lowestHz = 1, .highestHz = 75 * unit});
    REQUIRE(modes);
    CHECK(modes->zeroModes == 6);
    REQUIRE(modes->eigenvalues.size() >= 8);
    const auto f = frequenciesHz(modes->eigenvalues);
    for (int i = 0; i < 8; ++i)
        CHECK_THAT(f(i), WithinRel(theory[i] * unit, 0.03));
}

TEST_CASE("A thin hoop's in-plane modes come in pairs within 3 % of Hoppe's ring") {
    // The hoop is narrow, so that its section bends like a beam's.
    const double radius = 0.1, height = 0.006, thickness = 0.003;
    const auto material = referenceWood(1.0 / 3);
    const auto mesh = hoopMesh(radius, height, 360, 4);
    const double unit = std::sqrt(material.youngsModulusPa * thickness * thickness /
                                  (12 * material.densityKgPerM3)) /
                        (radius * radius) / (2 * std::numbers::pi);
    const auto modes = solveModes(twoLayerShell(mesh, material, thickness),
                                  {.lowestHz = 5, .highestHz = 16 * unit});
    REQUIRE(modes);
    CHECK(modes->zeroModes == 6);
    const auto shapes = midSurfaceShapes(modes->shapes);
    std::vector<double> inPlane;
    for (Eigen::Index mode = 0; mode < shapes.cols(); ++mode) {
        const double axial = shapes.col(mode).reshaped(3, mesh.vertexCount()).row(2).squaredNorm();
        if (axial < 0.1 * shapes.col(mode).squaredNorm())
            inPlane.push_back(frequenciesHz(modes->eigenvalues)(mode));
    }
    constexpr std::array theory{2.68328, 7.58947, 14.55214};
    REQUIRE(inPlane.size() >= 6);
    for (std::size_t i = 0; i < 6; ++i)
        CHECK_THAT(inPlane[i], WithinRel(theory[i / 2] * unit, 0.03));
}

TEST_CASE("A two-layer sphere keeps the membrane's five-fold l = 2 modes and six zero modes") {
    const auto material = referenceWood(1.0 / 3);
    const double radius = 0.1, thickness = 0.001;
    const double theory =
        0.68726 / radius *
        std::sqrt(material.youngsModulusPa / (material.densityKgPerM3 * (1 - 1.0 / 9))) /
        (2 * std::numbers::pi);
    const auto modes = solveModes(twoLayerShell(icosphereMesh(radius, 3), material, thickness),
                                  {.lowestHz = 20, .highestHz = 1.1 * theory});
    REQUIRE(modes);
    CHECK(modes->zeroModes == 6);
    REQUIRE(modes->eigenvalues.size() >= 5);
    const auto f = frequenciesHz(modes->eigenvalues);
    CHECK(f(4) / f(0) - 1 < 1e-6);
    CHECK_THAT(f(0), WithinRel(theory, 0.03));
}
