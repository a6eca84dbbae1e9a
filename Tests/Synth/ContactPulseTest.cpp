#include "Synth/ContactPulse.h"
#include "ModalReference.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("Forced plus free parts equal the convolution with the pulse within -180 dB") {
    const double hz = GENERATE(25.0, 440.0, 9000.0);
    const double damping = GENERATE(0.0, 20.0, 8000.0, 400000.0);
    const double contactSeconds = GENERATE(0.0001, 0.00314);
    const double extraDamping = GENERATE(0.0, 70.0);
    const double lambda = std::pow(2 * std::numbers::pi * hz, 2);
    const ModalPole pole{lambda, damping};
    const ReferenceMode mode{lambda, damping, 1};

    const ForcedResponse forced(pole, contactSeconds, extraDamping);
    const Motion edge = forced.motion(1);
    const ModalState away = stateOf(pole, {-edge.velocity, -edge.displacement});
    const ModalState again = stateOf(pole, edge);
    double peak = 0;
    double error = 0;
    for (int k = 1; k < 60; ++k) {
        const double t = contactSeconds * k / 20.0;
        double velocity = std::exp(-extraDamping * t) * (propagator(pole, t) * away).x;
        if (t < contactSeconds)
            velocity += forced.motion(std::polar(1.0, 2 * std::numbers::pi * k / 20)).velocity;
        else
            velocity += std::exp(-extraDamping * (t - contactSeconds)) *
                        (propagator(pole, t - contactSeconds) * again).x;
        const double expected = pulseVelocity(mode, contactSeconds, t, extraDamping);
        peak = larger(peak, std::abs(expected));
        error = larger(error, std::abs(velocity - expected));
    }
    CHECK(error < 1e-9 * peak);
}

TEST_CASE("A contact time within 1 % of a resonance's period moves away from it") {
    const std::vector<double> resonances{1000, 3000};
    for (const double seconds : {0.001, 0.001005, 0.000995}) {
        const double moved = contactSecondsClearOf(resonances, seconds);
        CHECK(std::abs(1000 * moved - 1) >= 0.0099);
        CHECK(std::abs(moved / seconds - 1) <= 0.0151);
    }
    CHECK(contactSecondsClearOf(resonances, 0.0012) == 0.0012);
    CHECK(contactSecondsClearOf({}, 0.001) == 0.001);
}

TEST_CASE("Rounding does not decide the direction in which a contact time moves") {
    const std::vector<double> resonances{1234.5};
    const double period = 1 / resonances[0];
    const double moved = contactSecondsClearOf(resonances, period);
    for (const double towards : {0.0, 1.0}) {
        const double near = std::nextafter(period, towards);
        CHECK(std::abs(contactSecondsClearOf(resonances, near) / moved - 1) < 1e-9);
    }
}

TEST_CASE("A contact time among resonances 1 % apart moves past all of them") {
    const std::vector<double> resonances{990.1, 1000, 1010.1};
    const double moved = contactSecondsClearOf(resonances, 0.001);
    for (const double hz : resonances)
        CHECK(std::abs(hz * moved - 1) >= 0.0099);
    CHECK(std::abs(moved / 0.001 - 1) <= 0.0301);
}
