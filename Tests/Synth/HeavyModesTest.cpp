#include "Synth/HeavyModes.h"

#include "Synth/UnitContact.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;

TEST_CASE("HeavyModes finds its modes in a range and moves only their saved states") {
    constexpr double sampleRate = 48000;
    const ModalPole pole{.stiffness = 1e6, .damping = 5000};
    HeavyModes heavy(4, sampleRate);
    heavy.add(3, pole);
    heavy.add(20, pole);
    CHECK(heavy.in(0, 16).size() == 1);
    CHECK(heavy.in(4, 20).empty());
    REQUIRE(heavy.in(16, 32).size() == 1);
    CHECK(heavy.in(16, 32)[0].mode == 20);

    ModeStates states(32, 1);
    states.set(20, 0, {1, 0.5});
    states.set(21, 0, {7, 7});
    heavy.save(states, 16, 32, 1);
    states.set(20, 0, {99, 99}); // what a SIMD loop leaves
    heavy.advance(16, 32, 1e-3, 0.5, 1, states);
    const ModalState moved = propagator(pole, 1e-3) * ModalState{1, 0.5};
    CHECK(std::abs(states.at(20, 0).x - 0.5 * moved.x) < 1e-15);
    CHECK(std::abs(states.at(20, 0).y - 0.5 * moved.y) < 1e-15);
    CHECK(states.at(21, 0).x == 7.0);
}

TEST_CASE("A heavy mode has no phase, so its residue is real with the same magnitude") {
    HeavyModes heavy(1, 48000);
    heavy.add(2, {.stiffness = 1e6, .damping = 5000});
    ModeResidues residues;
    residues[0].resize(modeBlock);
    residues[0].re[2] = -3;
    residues[0].im[2] = 4;
    residues[0].im[1] = 4;
    heavy.makeReal(residues, 1);
    CHECK(residues[0].re[2] == 5.0f);
    CHECK(residues[0].im[2] == 0.0f);
    CHECK(residues[0].im[1] == 4.0f);
}

TEST_CASE("An impulse on a mode that falls within a sample sounds as its mean over that time") {
    constexpr double sampleRate = 48000, damping = 8 * sampleRate;
    constexpr ModalPole fast{.stiffness = 1e10, .damping = damping};
    HeavyModes heavy(2, sampleRate);
    heavy.add(1, {.stiffness = 1e8, .damping = 1.99 * sampleRate});
    heavy.add(2, fast);
    UnitContact unit(modeBlock);
    unit.x[1] = unit.x[2] = 1;
    heavy.setImpulse(unit);
    CHECK(unit.x[1] == 1.0f);
    constexpr int steps = 10000;
    constexpr double seconds = 0.75 / sampleRate;
    Motion mean;
    for (int k = 0; k < steps; ++k) {
        const Motion at =
            motionOf(fast, propagator(fast, (k + 0.5) / steps * seconds) * ModalState{1, 0});
        mean.velocity += at.velocity / steps;
        mean.displacement += at.displacement / steps;
    }
    const ModalState expected = stateOf(fast, mean);
    CHECK(mean.velocity < 0.2);
    CHECK(std::abs(static_cast<double>(unit.x[2]) - expected.x) < 1e-5);
    CHECK(std::abs(static_cast<double>(unit.y[2]) - expected.y) < 1e-5);
}
