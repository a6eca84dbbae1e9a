#include "Instrument/StrikeSpectrum.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using Catch::Approx;

namespace {

constexpr double pi = std::numbers::pi;

TimedStrike contact(double delaySeconds, double impulse, double durationSeconds) {
    return {.delaySeconds = delaySeconds,
            .strike = {.point = {},
                       .impulseNewtonSeconds = {0, 0, static_cast<float>(-impulse)},
                       .durationSeconds = durationSeconds}};
}

/// Returns ∫ f(t) e^((α − iω) t) dt: the velocity's amplitude at t = 0 for a force f.
std::complex<double> bySum(const ContactTrain& train, double decay, double omega) {
    constexpr int steps = 20000;
    std::complex<double> sum = 0;
    for (const auto& each : train) {
        const double duration = each.strike.durationSeconds, step = duration / steps;
        const double impulse = std::abs(static_cast<double>(each.strike.impulseNewtonSeconds[2]));
        for (int k = 0; k < steps; ++k) {
            const double t = (k + 0.5) * step;
            const double force = impulse / duration * (1 - std::cos(2 * pi * t / duration));
            // The amplitude at 72.5 % of the contact, turned back to the start without its decay.
            sum += force * step * std::exp(-decay * (0.725 * duration - t)) *
                   std::polar(1.0, -omega * (each.delaySeconds + t));
        }
    }
    return sum;
}

} // namespace

TEST_CASE("The motion after raised cosines is the integral of their force and the mode's motion") {
    ContactTrain train;
    train.add(contact(0, 0.3, 1e-3));
    train.add(contact(2.5e-3, 0.1, 0.7e-3));
    for (const double hz : {50.0, 440.0, 1300.0, 5200.0})
        for (const double decay : {0.5, 60.0, 900.0}) {
            const auto found = ringingVelocity(train, decay, 2 * pi * hz);
            const auto expected = bySum(train, decay, 2 * pi * hz);
            INFO(hz << " Hz, decay " << decay);
            CHECK(std::abs(found - expected) < 1e-6 * 0.4);
        }
}

TEST_CASE(
    "A strike shorter than a period leaves its impulse, and one of whole periods leaves nothing") {
    ContactTrain brief, whole;
    brief.add(contact(0, 0.2, 1e-6));
    whole.add(contact(0, 0.2, 2.0 / 500));
    CHECK(std::abs(ringingVelocity(brief, 1, 2 * pi * 500)) == Approx(0.2).epsilon(1e-5));
    CHECK(std::abs(ringingVelocity(whole, 1e-6, 2 * pi * 500)) < 1e-8);
}

TEST_CASE("Stiff modes follow the force of a long contact, but soft ones do not") {
    const double seconds = 5e-3, omega = 2 * pi / seconds;
    const PressedMotion motion(contact(0, 0.4, seconds).strike, 48000);
    const auto velocity = motion.velocity({.stiffness = 9 * omega * omega}, {1, 1});
    CHECK(velocity.real() == Approx(0.4 / seconds * omega / (8 * omega * omega)));
    CHECK(velocity.imag() == Approx(velocity.real() / 3));
    CHECK(motion.velocity({.stiffness = omega * omega}, 1) == 0.0);
    CHECK(motion.energy(2) == Approx(4 * motion.energy(1)));
}
