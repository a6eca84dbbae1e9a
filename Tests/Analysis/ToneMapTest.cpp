#include "Analysis/ToneMap.h"
#include "Analysis/ModalAnalysis.h"
#include "Geometry/ParametricMesh.h"
#include "Support/SyntheticObject.h"

#include <algorithm>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Approx;
using test::syntheticObject;

namespace {

std::vector<double> mapOf(const ModalObject& object) {
    return brightnessHz(object, vertexNormals(object));
}

} // namespace

TEST_CASE("Brightness is the mean frequency of separate modes, weighted by a^2/4 alpha") {
    const auto object = syntheticObject({400, 3000}, {1.0f, 0.7f});
    double energy = 0, moment = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        const double decay = object.material.damping.perSecond(object.eigenvalues[i]) / 2;
        const double hz = std::sqrt(object.eigenvalues[i] - decay * decay) / (2 * std::numbers::pi);
        const double share = std::pow(i == 0 ? 1 : 0.7, 4) / (4 * decay);
        energy += share;
        moment += share * hz;
    }
    for (const double hz : mapOf(object))
        CHECK(hz == Approx(moment / energy).epsilon(1e-5));
}

TEST_CASE("Measured decay rates replace the material's") {
    auto object = syntheticObject({400, 3000});
    object.decaysPerSecond = {100, 1};
    CHECK(mapOf(object)[0] == Approx((400.0 / 100 + 3000) / (1.0 / 100 + 1)).epsilon(1e-3));
}

TEST_CASE("The map does not depend on the basis of two equal modes") {
    auto object = syntheticObject({400, 1000, 1000}, {0.5f, 0.8f, 0.0f});
    const auto before = mapOf(object);
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row) {
        auto* shapes = object.shapes.data() + 9 * row;
        shapes[5] = 0.8f * std::cos(0.6f);
        shapes[8] = 0.8f * std::sin(0.6f);
    }
    const auto after = mapOf(object);
    for (std::size_t row = 0; row < after.size(); ++row)
        CHECK(after[row] == Approx(before[row]).epsilon(1e-5));
}

TEST_CASE("Only audible modes count, and a silent point has no brightness") {
    CHECK(mapOf(syntheticObject({5, 300, 30000}))[0] == Approx(300).epsilon(1e-4));
    CHECK(mapOf(syntheticObject({300}, {0.0f}))[0] == 0);
}

TEST_CASE(
    "A bar's brightness is symmetric and higher at its fundamental's nodes than in the middle") {
    const double length = 0.3;
    AnalysisSettings settings;
    settings.material = *findMaterial("Steel");
    settings.material.damping = {.fluidPerSecond = 5, .viscoelasticSeconds = 3e-8};
    settings.method = AnalysisMethod::twoLayer;
    settings.thicknessMetres = 0.01;
    settings.maxFrequencyHz = 12000;
    const auto object =
        analyse(sheetMesh(length, 0.04, {.segmentsAlong = 40, .rowsAcross = 6}), settings);
    REQUIRE(object);
    const auto brightness = mapOf(*object);
    const auto at = [&](double x) {
        return brightness[nearestShapeRow(*object, {x * length, 0, 0})];
    };
    // The nodes of a free bar's fundamental lie at 0.2242 of its length from either end.
    const double node = 0.5 - 0.2242;
    CHECK(at(-node) > 1.5 * at(0));
    CHECK(at(0.5) > at(0));
    for (const double x : {0.1, 0.2, node, 0.35, 0.45, 0.5}) {
        CAPTURE(x, at(x));
        CHECK(at(-x) == Approx(at(x)).epsilon(0.01));
    }
}
