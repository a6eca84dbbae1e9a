#include "Analysis/Cavity.h"
#include "Support/SyntheticObject.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>
#include <numbers>
#include <vector>

using namespace idiophone;
using Catch::Matchers::WithinRel;

namespace {

constexpr double pi = std::numbers::pi;
constexpr Cavity cavity{
    .volumeM3 = 3e-4, .mouthM2 = 1e-3, .mouthLengthMetres = 0.1, .wallMetres = 0.01};

double stiffness() {
    return 1.204 * 343 * 343 / cavity.volumeM3;
}

/// A body of one mode, with its cavity.
ModalObject coupled(double frequencyHz, double inwardM3) {
    auto object = test::syntheticObject({frequencyHz});
    object.radiation = {.directions = {{0, 0, 1}}, .frequencyRatios = {1}, .weights = {{0, 1e-4f}}};
    addCavity(object, cavity, std::vector{inwardM3}, {0, 0, 0});
    return object;
}

} // namespace

TEST_CASE("A thin round hole conducts like its diameter, and a wall adds its own length") {
    constexpr double radius = 0.01;
    const Cavity bottle{.volumeM3 = 1e-3,
                        .mouthM2 = pi * radius * radius,
                        .mouthLengthMetres = 2 * radius,
                        .wallMetres = 0};
    CHECK_THAT(bottle.conductivityMetres(), WithinRel(2 * radius, 1e-9));
    Cavity thick = bottle;
    thick.wallMetres = 0.03;
    CHECK_THAT(1 / thick.conductivityMetres(),
               WithinRel(1 / (2 * radius) + 0.03 / bottle.mouthM2, 1e-9));
    CHECK_THAT(thick.frequencyHz(),
               WithinRel(343 / (2 * pi) * std::sqrt(thick.conductivityMetres() / 1e-3), 1e-9));
}

TEST_CASE("A long slit conducts better than a round hole of the same area") {
    Cavity round = cavity;
    round.mouthLengthMetres = 2 * std::sqrt(cavity.mouthM2 / pi);
    CHECK(cavity.frequencyHz() > 1.05 * round.frequencyHz());
    CHECK(cavity.frequencyHz() < 1.3 * round.frequencyHz());
}

TEST_CASE("A cavity's impedance is that of its resonance, lowest at its frequency") {
    const auto resonance = cavity.resonance();
    const double hz = cavity.frequencyHz();
    CHECK_THAT(resonance.omega, WithinRel(2 * pi * hz, 1e-12));
    CHECK(std::abs(cavity.impedancePaSPerM3(hz).imag()) <
          1e-9 * resonance.inertanceKgPerM4 * resonance.omega);
    CHECK_THAT(cavity.impedancePaSPerM3(hz).real(),
               WithinRel(2 * resonance.inertanceKgPerM4 * resonance.decayPerSecond, 1e-12));
    for (const double ratio : {0.8, 1.25})
        CHECK(std::abs(cavity.impedancePaSPerM3(ratio * hz)) >
              2 * std::abs(cavity.impedancePaSPerM3(hz)));
}

TEST_CASE("A wall's mode and its cavity have the modes of two coupled oscillators within 2 %") {
    const double detune = GENERATE(0.93, 1.0, 1.1);
    const double hz = detune * cavity.frequencyHz();
    // A tenth of the mode's own stiffness comes from the air.
    const double inward = std::sqrt(0.01 * std::pow(2 * pi * hz, 2) / stiffness());
    const auto object = coupled(hz, inward);
    REQUIRE(object.modeCount() == 2);

    // The air is a spring between the wall's volume and the flow into the cavity.
    const auto air = cavity.resonance();
    Eigen::Matrix2d springs;
    const double between = stiffness() * inward / std::sqrt(air.inertanceKgPerM4);
    springs << std::pow(2 * pi * hz, 2) + stiffness() * inward * inward, between, between,
        air.omega * air.omega;
    const Eigen::Vector2d exact =
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(springs).eigenvalues();
    CHECK_THAT(std::sqrt(object.eigenvalues[0]), WithinRel(std::sqrt(exact(0)), 0.02));
    CHECK_THAT(std::sqrt(object.eigenvalues[1]), WithinRel(std::sqrt(exact(1)), 0.02));
    CHECK(std::abs(object.gains[0] + object.gains[1] - 1.0f) < 0.05f);
}

TEST_CASE("Far below the resonance the flow takes back what the wall pushes out") {
    constexpr double inward = 1e-3;
    const auto object = coupled(30, inward);
    REQUIRE(object.modeCount() == 1);
    const double omega = std::sqrt(object.eigenvalues[0]);
    // A monopole of the volume that the wall takes from the cavity, in phase with the wall.
    const double expected = omega * 1.204 / (4 * pi) * inward;
    const std::complex<double> ofMouth =
        std::complex<double>(object.radiation.weights[0]) - std::complex<double>(0, 1e-4);
    CHECK_THAT(std::abs(ofMouth), WithinRel(expected, 0.02));
}
