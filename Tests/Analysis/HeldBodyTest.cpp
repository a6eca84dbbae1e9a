// Tests clamps: regions, and held bodies against theory (Blevins 1979; Leissa 1969).
#include "Analysis/HeldBody.h"

#include "Analysis/ModalAnalysis.h"
#include "Geometry/ParametricMesh.h"
#include "TestMaterials.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double lengthMetres = 0.2, widthMetres = 0.01, heightMetres = 0.005;
constexpr std::array cantileverBetas{1.87510407, 4.69409113, 7.85475744};

AnalysisSettings heldAt(std::initializer_list<const char*> clamps) {
    AnalysisSettings settings{.name = "held", .source = "a test", .material = referenceWood(0.3)};
    settings.listeningDirections.clear();
    for (const char* text : clamps)
        settings.support.clamps.push_back(parseClamp(text).value());
    return settings;
}

double hertz(const ModalObject& object, std::size_t mode) {
    return std::sqrt(object.eigenvalues[mode]) / (2 * pi);
}

Mesh bar() {
    return boxMesh({lengthMetres, widthMetres, heightMetres}, {40, 2, 1});
}

/// Returns a frequency of a cantilever of Euler and Bernoulli.
double cantileverHz(double betaLength, double thicknessMetres, const Material& material) {
    const double beta = betaLength / lengthMetres;
    return beta * beta * thicknessMetres *
           std::sqrt(material.youngsModulusPa / (12 * material.densityKgPerM3)) / (2 * pi);
}

} // namespace

TEST_CASE("A region is read as a list of sides, or refused") {
    const auto region = parseClamp(" x > -0.1 , z<1e-3");
    REQUIRE(region.has_value());
    const std::array regions{*region};
    CHECK(isClamped(regions, {0, 5, 0}));
    CHECK(isClamped(regions, {-0.1, 0, 1e-3}));
    CHECK_FALSE(isClamped(regions, {-0.2, 0, 0}));
    CHECK_FALSE(isClamped(regions, {0, 0, 0.01}));
    CHECK_FALSE(isClamped({}, {0, 0, 0}));
    for (const char* wrong : {"", "x", "x<", "w<1", "x=1", "x<1,", "x<1 2x", "x<nan", "x<<1"})
        CHECK_FALSE(parseClamp(wrong).has_value());
}

TEST_CASE("A bar held at one end has the frequencies of a cantilever within 1 %") {
    const auto settings = heldAt({"x<-0.0999"});
    const auto object = analyse(bar(), settings);
    REQUIRE(object.has_value());
    CHECK(object->provenance.zeroModes == 0);
    for (const double betaLength : cantileverBetas) {
        const double wantedHz = cantileverHz(betaLength, heightMetres, settings.material);
        const auto nearest = std::ranges::min(object->eigenvalues, {}, [&](double eigenvalue) {
            return std::abs(std::sqrt(eigenvalue) / (2 * pi) - wantedHz);
        });
        CHECK_THAT(std::sqrt(nearest) / (2 * pi), WithinRel(wantedHz, 0.01));
    }
    const double sidewaysHz = cantileverHz(cantileverBetas[0], widthMetres, settings.material);
    CHECK_THAT(hertz(*object, 1), WithinRel(sidewaysHz, 0.01));
    REQUIRE_FALSE(object->clampedVertices.empty());
    for (const auto vertex : object->clampedVertices) { // every vertex carries shapes
        const auto shapes = object->shapesAt(static_cast<std::size_t>(vertex));
        CHECK(std::ranges::all_of(shapes, [](float shape) { return shape == 0.0f; }));
    }
}

TEST_CASE("A square plate held at all edges, or at one, has Leissa's frequencies within 1 %") {
    constexpr double side = 0.2, thickness = 0.001;
    auto settings = heldAt({"x<-0.0999", "x>0.0999", "y<-0.0999", "y>0.0999"});
    settings.thicknessMetres = thickness;
    settings.method = AnalysisMethod::twoLayer;
    settings.lowestFrequencyHz = 5;
    settings.maxFrequencyHz = 1000;
    const auto& material = settings.material;
    const double rigidity = material.youngsModulusPa * std::pow(thickness, 3) /
                            (12 * (1 - std::pow(material.poissonRatio, 2)));
    const auto expectedHz = [&](double omega) {
        return omega / (side * side) * std::sqrt(rigidity / (material.densityKgPerM3 * thickness)) /
               (2 * pi);
    };
    const auto mesh = sheetMesh(side, side, 2500);
    const auto held = analyse(mesh, settings);
    REQUIRE(held.has_value());
    constexpr std::array clamped{35.985, 73.394, 73.394, 108.22};
    for (std::size_t mode = 0; mode < clamped.size(); ++mode)
        CHECK_THAT(hertz(*held, mode), WithinRel(expectedHz(clamped[mode]), 0.01));

    settings.support = heldAt({"x<-0.0999"}).support;
    const auto cantilever = analyse(mesh, settings);
    REQUIRE(cantilever.has_value());
    constexpr std::array atOneEdge{3.471, 8.508, 21.29, 27.20, 30.96};
    for (std::size_t mode = 0; mode < atOneEdge.size(); ++mode)
        CHECK_THAT(hertz(*cantilever, mode), WithinRel(expectedHz(atOneEdge[mode]), 0.01));
}

TEST_CASE("A support takes the power that the force at the clamp gives its resistance") {
    constexpr double resistanceNsPerM = 1000;
    auto settings = heldAt({"x<-0.0999"});
    settings.support.resistanceNsPerM = resistanceNsPerM;
    const auto object = analyse(bar(), settings);
    REQUIRE(object.has_value());
    // The shear force at a cantilever's root is 2 s E I b^3 / sqrt(m), m = its mass.
    constexpr double s = 0.734095514;
    const double inertia = widthMetres * std::pow(heightMetres, 3) / 12;
    const double massKg =
        settings.material.densityKgPerM3 * lengthMetres * widthMetres * heightMetres;
    const double force = 2 * s * settings.material.youngsModulusPa * inertia *
                         std::pow(cantileverBetas[0] / lengthMetres, 3) / std::sqrt(massKg);
    REQUIRE(object->extraDecaysPerSecond.size() == object->modeCount());
    CHECK_THAT(object->extraDecaysPerSecond[0],
               WithinRel(force * force / (2 * resistanceNsPerM * object->eigenvalues[0]), 0.03));
    settings.support.resistanceNsPerM = -1;
    CHECK_FALSE(analyse(bar(), settings).has_value());
}

TEST_CASE("Clamps that hold nothing or everything are refused in a sentence") {
    CHECK(analyse(bar(), heldAt({"x<-1"})).error().message ==
          "The clamps hold no point of the object; check their places, in metres.");
    CHECK(analyse(bar(), heldAt({"x<1"})).error().message == "The clamps hold the whole object.");
}
