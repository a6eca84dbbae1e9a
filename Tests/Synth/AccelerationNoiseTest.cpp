#include "Synth/AccelerationNoise.h"

#include "Support/RigidBall.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double airDensity = 1.2, soundSpeed = 343;
constexpr std::array<float, 3> up{0, 0, 1};

std::array<float, 3> upwards(double impulse) {
    return {0, 0, static_cast<float>(impulse)};
}

/// The click of a ball at its reference size, straight up and `towards`.
RigidClick clickOf(const ModalObject& ball,
                   double impulse,
                   double contactSeconds,
                   const std::array<float, 3>& towards = up) {
    constexpr double sampleRateHz = 1e9; // so that no click is lengthened
    return rigidClick(rigidRadiator(ball), upwards(impulse), contactSeconds, 1, sampleRateHz,
                      {up, towards});
}

/// Far pressure times distance on the axis of a sphere with velocity ∝ e^{iωt} (Morse & Ingard
/// 7.1.12), as its amplitude for an acceleration of 1 m/s². Exact at any ka.
std::complex<double> exactPerAcceleration(double radiusMetres, double omega) {
    const std::complex<double> i(0, 1);
    const double ka = omega * radiusMetres / soundSpeed;
    return airDensity * std::pow(radiusMetres, 3) * i * omega / soundSpeed /
           (2.0 + 2.0 * i * ka - ka * ka);
}

/// ∫ f(t/T) e^{−iωt} dt over 0 ≤ t ≤ T.
template <class Function>
std::complex<double> spectrum(Function f, double seconds, double omega) {
    std::complex<double> sum = 0;
    constexpr int steps = 4000;
    for (int k = 0; k < steps; ++k) {
        const double share = (k + 0.5) / steps;
        sum += seconds / steps * f(share) * std::polar(1.0, -omega * share * seconds);
    }
    return sum;
}

/// Volume of the moved air over that of a solid ellipsoid, along its axes. The axes x and y are
/// turned by 30° about z.
std::array<double, 3> addedShares(double a, double b, double c) {
    const double massKg = 2, turn = pi / 6;
    const double along = massKg * (b * b + c * c) / 5, across = massKg * (a * a + c * c) / 5;
    const double cosine = std::cos(turn), sine = std::sin(turn);
    const double mixed = (along - across) * sine * cosine;
    auto object = rigidBall(0.01, 1000);
    object.mass = {.massKg = massKg,
                   .inertiaKgM2 = {along * cosine * cosine + across * sine * sine, mixed, 0, mixed,
                                   along * sine * sine + across * cosine * cosine, 0, 0, 0,
                                   massKg * (a * a + b * b) / 5}};
    const double volume = 4 * pi / 3 * a * b * c;
    object.material.densityKgPerM3 = massKg / volume;
    const auto volumes = rigidRadiator(object).volumes;
    const auto share = [&](double x, double y) {
        return (x * x * volumes[0] + 2 * x * y * volumes[1] + y * y * volumes[4]) / volume - 1;
    };
    return {share(cosine, sine), share(-sine, cosine), volumes[8] / volume - 1};
}

} // namespace

TEST_CASE("The moved air of an ellipsoid matches Lamb's formula in any orientation") {
    for (const double share : addedShares(0.02, 0.02, 0.02))
        CHECK(share == Approx(0.5).epsilon(1e-3));
    // Axes 2 : 1 : 1: α0 = 2 (1 − e²)/e³ (artanh e − e) with e² = 3/4, β0 = 1 − α0/2.
    const auto prolate = addedShares(0.04, 0.02, 0.02);
    CHECK(prolate[0] == Approx(0.2100).margin(2e-4));
    CHECK(prolate[1] == Approx(0.7042).margin(2e-4));
    CHECK(prolate[2] == Approx(0.7042).margin(2e-4));
    // A disc moves 8/3 a³.
    const auto disc = addedShares(0.1, 0.1, 0.005);
    CHECK(disc[2] * 4 * pi / 3 * 0.005 / 0.1 == Approx(8.0 / 3).epsilon(0.05));
}

TEST_CASE("A small sphere's click is rho a^3 jerk/(2c) along the impulse, and follows its cosine") {
    const double radius = 0.01, impulse = 0.05, contact = 1e-3;
    const auto ball = rigidBall(radius, 7000);
    const auto [seconds, pascals] = clickOf(ball, impulse, contact, {0.8f, 0, -0.6f});
    const double steepest = impulse / ball.mass.massKg * 2 * pi / (seconds * seconds);
    CHECK(pascals[0] ==
          Approx(airDensity * std::pow(radius, 3) * steepest / (2 * soundSpeed)).epsilon(1e-3));
    CHECK(pascals[1] == Approx(-0.6 * pascals[0]).epsilon(1e-6));
    CHECK(clickOf(ball, impulse, contact, {1, 0, 0}).pascalMetres[1] ==
          Approx(0).margin(1e-6 * pascals[0]));
}

TEST_CASE("The click's spectrum matches an oscillating sphere's within 1.2 dB up to ka = 1") {
    const double radius = 0.01, impulse = 0.05;
    const auto ball = rigidBall(radius, 7000);
    for (const double contact : {1e-6, 3e-5, 1e-4, 1e-3}) {
        CAPTURE(contact);
        const auto [seconds, pascals] = clickOf(ball, impulse, contact);
        for (const double ka : {0.02, 0.1, 0.3, 1.0}) {
            const double omega = ka * soundSpeed / radius;
            if (omega * contact > 2 * pi)
                continue; // beyond the main lobe
            const auto spectrumOfClick =
                spectrum([](double t) { return std::sin(2 * pi * t); }, seconds, omega);
            const auto pulse =
                spectrum([&](double t) { return 1 - std::cos(2 * pi * t); }, contact, omega) /
                contact;
            const double expected =
                std::abs(exactPerAcceleration(radius, omega) * pulse) * impulse / ball.mass.massKg;
            CAPTURE(ka);
            CHECK(20 * std::log10(pascals[0] * std::abs(spectrumOfClick) / expected) ==
                  Approx(0).margin(ka < 0.2 ? 0.1 : 1.2));
        }
    }
}

TEST_CASE("Denser bodies and longer contacts click more softly, and harder strikes click louder") {
    // These contacts are so long that the size of the ball does not lengthen the clicks.
    const auto click = [](double density, double impulse, double seconds) {
        return clickOf(rigidBall(0.01, density), impulse, seconds).pascalMetres[0];
    };
    const double usual = click(7000, 0.05, 0.1);
    CHECK(click(14000, 0.05, 0.1) == Approx(usual / 2));
    CHECK(click(7000, 0.1, 0.1) == Approx(usual * 2));
    CHECK(click(7000, 0.05, 0.2) == Approx(usual / 4));
}

TEST_CASE("A held body and a body with impossible inertia do not click") {
    auto ball = rigidBall(0.01, 7000);
    ball.provenance.zeroModes = 0;
    CHECK(rigidRadiator(ball).massKg == 0);
    ball.provenance.zeroModes = 6;
    CHECK(rigidRadiator(ball).massKg > 0);
    ball.mass.inertiaKgM2 = {1e-3, 0, 0, 0, 1e-9, 0, 0, 0, 1e-9};
    CHECK(rigidRadiator(ball).massKg == 0);
    ball.mass.inertiaKgM2 = {};
    CHECK(rigidRadiator(ball).massKg == 0);
}
