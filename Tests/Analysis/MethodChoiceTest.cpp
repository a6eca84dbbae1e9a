#include "Analysis/MethodChoice.h"

#include "Analysis/ModalAnalysis.h"
#include "Geometry/MeshRepair.h"
#include "Geometry/ParametricMesh.h"
#include "Geometry/TestMeshes.h"
#include "TestMaterials.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::WithinRel;

namespace {

MethodChoice choiceFor(const Mesh& mesh) {
    return chooseMethod(checkMesh(repairMesh(mesh)->mesh), 0.002);
}

AnalysisSettings settingsOf(double maxFrequencyHz) {
    return {.name = "thing",
            .source = "test",
            .material = referenceWood(),
            .maxFrequencyHz = maxFrequencyHz};
}

Mesh twoCrossedBoxes() {
    const Mesh one = boxMesh({0.3, 0.05, 0.02}, {6, 2, 1});
    Mesh turned = one;
    turned.vertices.col(0) = one.vertices.col(1);
    turned.vertices.col(1) = one.vertices.col(0);
    turned.vertices.col(2).array() += 0.001;
    return joined(one, turned);
}

} // namespace

TEST_CASE("Closed thick meshes are analysed as solids, thin or open ones as shells") {
    CHECK(choiceFor(boxMesh({0.35, 0.05, 0.02}, {14, 2, 1})).method == AnalysisMethod::tetrahedra);
    CHECK(choiceFor(icosphereMesh(0.1, 2)).method == AnalysisMethod::tetrahedra);
    CHECK(choiceFor(torusMesh(0.1, 0.01, 40, 10)).method == AnalysisMethod::tetrahedra);

    const MethodChoice open = choiceFor(sheetMesh(0.3, 0.05, 200));
    CHECK(open.method == AnalysisMethod::twoLayer);
    CHECK_THAT(open.reason, ContainsSubstring("2 mm") && ContainsSubstring("open"));
    const MethodChoice thin = choiceFor(boxMesh({0.5, 0.4, 0.002}, {25, 20, 1}));
    CHECK(thin.method == AnalysisMethod::twoLayer);
    CHECK_THAT(thin.reason, ContainsSubstring("thin"));
    const MethodChoice crossed = choiceFor(twoCrossedBoxes());
    CHECK(crossed.method == AnalysisMethod::twoLayer);
    CHECK_THAT(crossed.reason, ContainsSubstring("passes through itself"));
}

TEST_CASE("An analysis without a given method reports its choice and the reason") {
    const auto solid = analyse(boxMesh({0.35, 0.05, 0.02}, {14, 2, 1}), settingsOf(6000));
    REQUIRE(solid);
    CHECK(solid->method == "fem");
    CHECK(solid->body == BodyKind::solid);
    CHECK(solid->thicknessMetres == 0);
    CHECK_THAT(solid->provenance.notes, ContainsSubstring("closed and thick"));
    const auto shell = analyse(sheetMesh(0.3, 0.05, 200), settingsOf(6000));
    REQUIRE(shell);
    CHECK(shell->method == "two-layer");
    CHECK_THAT(shell->provenance.notes, ContainsSubstring("is open"));
}

TEST_CASE("A solid bar given as a coarse box matches Timoshenko within 1 %") {
    // 0.4 x 0.05 x 0.02 m, Y 20 GPa, nu 0.25: 569.6 1545.4 2963.4 Hz.
    const auto object = analyse(boxMesh({0.4, 0.05, 0.02}, {1, 1, 1}), settingsOf(4000));
    REQUIRE(object);
    CHECK(object->method == "fem");
    for (const double hz : {569.6, 1545.4, 2963.4}) {
        double nearest = 0;
        for (const double eigenvalue : object->eigenvalues) {
            const double found = std::sqrt(eigenvalue) / (2 * std::numbers::pi);
            if (std::abs(found - hz) < std::abs(nearest - hz))
                nearest = found;
        }
        CHECK_THAT(nearest, WithinRel(hz, 0.01));
    }
    CHECK_THAT(object->mass.massKg, WithinRel(0.4, 1e-9));
    CHECK_THAT(object->mass.inertiaKgM2[0],
               WithinRel(0.4 * (0.05 * 0.05 + 0.02 * 0.02) / 12, 1e-6));
    CHECK_THAT(object->mass.inertiaKgM2[4], WithinRel(0.4 * (0.4 * 0.4 + 0.02 * 0.02) / 12, 1e-6));
    CHECK(object->provenance.zeroModes == 6);
}

TEST_CASE("Finite elements for a mesh without a body give a one-sentence error") {
    AnalysisSettings settings = settingsOf(6000);
    settings.method = AnalysisMethod::tetrahedra;
    CHECK_THAT(analyse(sheetMesh(0.3, 0.05, 200), settings).error().message,
               ContainsSubstring("cannot be taken as a solid, because its surface is open"));
    CHECK_THAT(analyse(twoCrossedBoxes(), settings).error().message,
               ContainsSubstring("passes through itself"));
}

TEST_CASE("A band beyond the element budget ends earlier, and a note says so") {
    Material soft = referenceWood();
    soft.youngsModulusPa = 1e7; // rubber: waves of a few millimetres
    AnalysisSettings settings = settingsOf(44000);
    settings.material = soft;
    settings.elementBudget = 1500;
    const auto object = analyse(boxMesh({0.35, 0.05, 0.02}, {14, 2, 1}), settings);
    REQUIRE(object);
    CHECK(object->bandHz < 10000);
    CHECK(std::sqrt(object->eigenvalues.back()) / (2 * std::numbers::pi) <= object->bandHz);
    CHECK_THAT(object->provenance.notes, ContainsSubstring("The band ends at"));
}

TEST_CASE("Vertices chosen for shapes are found again on a remeshed surface") {
    const Mesh mesh = boxMesh({0.35, 0.05, 0.02}, {1, 1, 1});
    AnalysisSettings settings = settingsOf(6000);
    settings.shapeVertices = {0, 7};
    const auto object = analyse(mesh, settings);
    REQUIRE(object);
    REQUIRE(object->shapeVertices.size() == 2);
    for (const std::int32_t vertex : object->shapeVertices) {
        const auto* at = object->vertices.data() + 3 * static_cast<std::size_t>(vertex);
        CHECK_THAT(std::abs(at[0]), WithinRel(0.175f, 1e-5f)); // corners are kept
        CHECK_THAT(std::abs(at[1]), WithinRel(0.025f, 1e-5f));
    }
}
