#include "Analysis/CordSupport.h"

#include "Support/SyntheticObject.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <vector>

using namespace idiophone;
using Catch::Matchers::WithinAbs;
using Catch::Matchers::WithinRel;

namespace {

constexpr double lengthMetres = 0.4, halfWidthMetres = 0.02, massKg = 0.5;
constexpr int lines = 161, fundamental = 0, second = 1, twist = 2, sideways = 3;
constexpr double node = 0.2241575; // node of a free bar's fundamental / its length

/// Returns the free-free shape of Euler and Bernoulli at x (fraction of the length); its mean
/// square is 1.
double bendingShape(double wave, double x) {
    const double ratio = (std::cosh(wave) - std::cos(wave)) / (std::sinh(wave) - std::sin(wave));
    return std::cosh(wave * x) + std::cos(wave * x) -
           ratio * (std::sinh(wave * x) + std::sin(wave * x));
}
double fundamentalShape(double x) {
    return bendingShape(4.730040745, x);
}
double secondShape(double x) {
    return bendingShape(7.853204624, x);
}

/// A uniform bar with two bending modes, a torsional mode and a sideways mode.
ModalObject bar() {
    auto object = test::syntheticObject({400, 1100, 1500, 1700});
    object.vertices.clear();
    object.shapes.clear();
    object.shapeVertices.clear();
    for (int across = -1; across <= 1; ++across)
        for (int line = 0; line < lines; ++line) {
            const double x = line / (lines - 1.0), scale = 1 / std::sqrt(massKg);
            object.shapeVertices.push_back(static_cast<std::int32_t>(object.shapeVertices.size()));
            for (const double coordinate :
                 {(x - 0.5) * lengthMetres, across * halfWidthMetres, 0.0})
                object.vertices.push_back(static_cast<float>(coordinate));
            for (const double motion :
                 {0.0, 0.0, fundamentalShape(x), 0.0, 0.0, secondShape(x), 0.0, 0.0,
                  across * std::cos(3.14159265358979 * x), 0.0, fundamentalShape(x), 0.0})
                object.shapes.push_back(static_cast<float>(scale * motion));
        }
    return object;
}

std::vector<double> addedBy(const CordSupport& cords) {
    auto object = bar();
    const auto without = object;
    addCordLoss(object, cords);
    std::vector<double> added;
    for (std::size_t mode = 0; mode < object.modeCount(); ++mode)
        added.push_back(object.decayPerSecond(mode) - without.decayPerSecond(mode));
    return added;
}

double square(double value) {
    return value * value;
}

} // namespace

TEST_CASE("Cords lie at the nodes of a uniform bar's fundamental, 22.4 % from its ends") {
    const auto places = cordPlacesMetres(bar());
    REQUIRE(places.size() == 2);
    CHECK_THAT(places[0], WithinAbs((node - 0.5) * lengthMetres, 1e-4 * lengthMetres));
    CHECK_THAT(places[1], WithinAbs((0.5 - node) * lengthMetres, 1e-4 * lengthMetres));
}

TEST_CASE("Each cord at a node adds R phi^2 / 2 to other modes' decay rates and nothing to the "
          "fundamental") {
    const auto added = addedBy({.resistanceNsPerM = 3, .spreadOverLength = 0});
    CHECK_THAT(added[fundamental], WithinAbs(0, 1e-3));
    // Each cord adds half of R φ². Both together give R φ² for a symmetric or antisymmetric mode.
    CHECK_THAT(added[second], WithinRel(3 * square(secondShape(node)) / massKg, 2e-3));
    // The edges carry half of the weight across the width.
    CHECK_THAT(added[twist],
               WithinRel(3 * square(std::cos(3.14159265358979 * node)) / 2 / massKg, 2e-3));
    CHECK_THAT(added[sideways], WithinAbs(0, 1e-9));
}

TEST_CASE("Cords beside the nodes damp the fundamental by the mean square of both sides") {
    const auto added = addedBy({.resistanceNsPerM = 3, .spreadOverLength = 0.05});
    const auto expected = [](double (*shape)(double)) {
        return 3 * (square(shape(node - 0.05)) + square(shape(node + 0.05))) / 2 / massKg;
    };
    CHECK_THAT(added[fundamental], WithinRel(expected(fundamentalShape), 5e-3));
    CHECK_THAT(added[second], WithinRel(expected(secondShape), 5e-3));
}

TEST_CASE(
    "Cords with a resistance exponent of -1 damp a mode in inverse proportion to its frequency") {
    const auto dashpot = addedBy({.resistanceNsPerM = 3});
    const auto spring = addedBy({.resistanceNsPerM = 3, .resistanceExponent = -1});
    const auto object = bar();
    for (const std::size_t mode : {fundamental, second, twist})
        CHECK_THAT(spring[mode],
                   WithinRel(dashpot[mode] * 1000 / object.dampedFrequencyHz(mode), 1e-6));
}

TEST_CASE("Cord loss is added to existing decay rates") {
    auto object = bar();
    object.extraDecaysPerSecond = {1, 2, 3, 4};
    addCordLoss(object, {.resistanceNsPerM = 0});
    CHECK(object.extraDecaysPerSecond == std::vector<double>{1, 2, 3, 4});
    addCordLoss(object, {.resistanceNsPerM = 3, .spreadOverLength = 0});
    CHECK_THAT(object.extraDecaysPerSecond[second],
               WithinRel(2 + 3 * square(secondShape(node)) / massKg, 2e-3));
}

TEST_CASE("A body whose lowest bending mode lacks two nodes keeps its decay rates") {
    auto object = test::syntheticObject({400});
    addCordLoss(object, {});
    CHECK(object.extraDecaysPerSecond.empty());
}
