#include "Synth/AccelerationNoise.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <complex>
#include <numbers>

using namespace idiophone;
using Catch::Approx;

namespace {

constexpr double pi = std::numbers::pi;
constexpr double airDensity = 1.2, soundSpeed = 343;

RigidRadiator sphere(double radiusMetres, double massKg) {
    const double volume = 4.0 / 3.0 * pi * std::pow(radiusMetres, 3);
    return {.massKg = massKg, .volumeCubicMetres = volume, .addedVolumeCubicMetres = volume / 2};
}

/// Far pressure times distance on the axis of a sphere whose velocity goes as e^{iωt} (Morse &
/// Ingard 7.1.12), as its amplitude for an acceleration of 1 m/s²: exact at any ka.
std::complex<double> exactPerAcceleration(double radiusMetres, double omega) {
    const std::complex<double> i(0, 1);
    const double ka = omega * radiusMetres / soundSpeed;
    return airDensity * std::pow(radiusMetres, 3) * i * omega / soundSpeed /
           (2.0 + 2.0 * i * ka - ka * ka);
}

/// Of the acceleration (J/(M T))(1 − cos Ωt), 0 ≤ t ≤ T.
std::complex<double> accelerationSpectrum(double speed, double seconds, double omega) {
    std::complex<double> sum = 0;
    constexpr int steps = 4000;
    for (int k = 0; k < steps; ++k) {
        const double t = (k + 0.5) / steps;
        sum += speed / steps * (1 - std::cos(2 * pi * t)) * std::polar(1.0, -omega * t * seconds);
    }
    return sum;
}

} // namespace

TEST_CASE("The click of a small sphere is ρ0 a³ ȧ / (2 c)") {
    const double radius = 0.01, mass = 0.03, impulse = 0.05, seconds = 1e-3;
    const double steepest = impulse / mass * 2 * pi / (seconds * seconds);
    CHECK(clickPascalMetres(sphere(radius, mass), impulse, seconds) ==
          Approx(airDensity * std::pow(radius, 3) * steepest / (2 * soundSpeed)));
}

TEST_CASE("The click's spectrum is that of an oscillating sphere within 0.1 dB below ka = 0.2") {
    const double radius = 0.01, mass = 0.03, impulse = 0.05, seconds = 1e-3;
    const double amplitude = clickPascalMetres(sphere(radius, mass), impulse, seconds);
    for (const double ka : {0.02, 0.05, 0.1, 0.2}) {
        const double omega = ka * soundSpeed / radius;
        // ∫ sin(2πt/T) e^{−iωt} dt over the contact.
        std::complex<double> sum = 0;
        constexpr int steps = 4000;
        for (int k = 0; k < steps; ++k) {
            const double t = (k + 0.5) / steps;
            sum += seconds / steps * std::sin(2 * pi * t) * std::polar(1.0, -omega * t * seconds);
        }
        const double expected = std::abs(exactPerAcceleration(radius, omega) *
                                         accelerationSpectrum(impulse / mass, seconds, omega));
        CHECK(20 * std::log10(amplitude * std::abs(sum) / expected) == Approx(0).margin(0.1));
    }
}

TEST_CASE("Heavier bodies and longer contacts click more softly, larger ones louder") {
    const double usual = clickPascalMetres(sphere(0.01, 0.03), 0.05, 1e-3);
    CHECK(clickPascalMetres(sphere(0.01, 0.06), 0.05, 1e-3) == Approx(usual / 2));
    CHECK(clickPascalMetres(sphere(0.01, 0.03), 0.05, 2e-3) == Approx(usual / 4));
    CHECK(clickPascalMetres(sphere(0.02, 0.03), 0.05, 1e-3) == Approx(usual * 8));
}
