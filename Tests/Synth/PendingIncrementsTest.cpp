#include "ResonatorParts.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// One resonator of three modes with residues 1, 4 and 9, which starts at rest.
struct StruckAtRest : ResonatorParts {
    StruckAtRest() : ResonatorParts(ringingObject({440, 700, 5000}, 20, {1, 2, 3})) {
        residues.compute({}, {0, 0, -1}, {});
    }

    void strike(double at) {
        scratch.contact.setImpulse(bank.poles());
        increments.start(1, at);
        active.join({increments.energies(), active.tauEnergy(), increments.energies()}, 3, false,
                    1);
    }

    /// Returns the sum of `response` over the modes.
    template <class Response>
    double sum(const Response& response) const {
        double total = 0;
        for (std::size_t g = 0; g < 3; ++g)
            total += response(ReferenceMode{bank.pole(g).stiffness, bank.pole(g).damping,
                                            static_cast<double>((g + 1) * (g + 1))});
        return total;
    }

    PendingIncrements increments{bank, output, active, scratch};
};

} // namespace

TEST_CASE("Increments of an impulse sound from their sample on") {
    StruckAtRest struck;
    struck.strike(10.25);
    std::array<float, cellSamples> cell{};
    struck.increments.sound(firstSampleFrom(10.25), 40, cell);
    for (std::size_t k = 0; k < cellSamples; ++k) {
        const double seconds = (static_cast<double>(k) - 10.25) / struck.sampleRateHz;
        const double expected = k > 10 && k < 40 ? struck.sum([&](const ReferenceMode& mode) {
            return impulseVelocity(mode, seconds);
        })
                                                 : 0;
        CHECK(std::abs(double(cell[k]) - expected) < 1e-5);
    }
    CHECK(!struck.increments.pending());
}

TEST_CASE("Kept increments join the states at the next grid point, after the damper") {
    StruckAtRest struck;
    struck.output.setDamping(100, 0);
    struck.strike(10.25);
    std::array<float, cellSamples> cell{};
    struck.increments.soundAndKeep(11, cell);
    CHECK(struck.increments.pending());
    CHECK(struck.bank.state(1).x == 0.0);
    struck.increments.takeIn(1);
    CHECK(!struck.increments.pending());
    const double seconds = (64 - 10.25) / struck.sampleRateHz;
    for (std::size_t g = 0; g < 3; ++g) {
        const ModalPole pole = struck.bank.pole(g);
        const double residue = static_cast<double>((g + 1) * (g + 1));
        const ModalState start = stateOf(pole, {.velocity = residue});
        const ModalState moved = propagator(pole, seconds) * start;
        const double damper = std::exp(-100 * seconds);
        CHECK(std::abs(struck.bank.state(g).x - damper * moved.x) < 1e-5);
        CHECK(std::abs(struck.bank.state(g).y - damper * moved.y) < 1e-5);
        const double fall = std::exp(-(100 + pole.damping / 2) * 0.75 / struck.sampleRateHz);
        CHECK(std::abs(std::sqrt(double(struck.increments.energies()[g])) -
                       fall * std::hypot(start.x, start.y)) < 1e-5);
    }
    struck.increments.takeIn(2);
    CHECK(std::abs(struck.bank.state(0).x) < 1);
}

TEST_CASE("Increments of a whole contact sound like its pulse after its end") {
    StruckAtRest struck;
    constexpr double start = 3.5, contactSamples = 20;
    const double contactSeconds = contactSamples / struck.sampleRateHz;
    struck.scratch.contact.setForced(struck.bank.poles(), {.contactSeconds = contactSeconds});
    struck.increments.start(-1, start);
    struck.active.join(
        {struck.increments.energies(), struck.active.tauEnergy(), struck.increments.energies()}, 3,
        false, 1);
    struck.increments.finish(contactSeconds, start + contactSamples);
    std::array<float, cellSamples> cell{};
    struck.increments.soundAndKeep(24, cell);
    for (std::size_t k = 24; k < cellSamples; ++k) {
        const double seconds = (static_cast<double>(k) - start) / struck.sampleRateHz;
        const double expected = struck.sum([&](const ReferenceMode& mode) {
            return pulseVelocity(mode, contactSeconds, seconds);
        });
        CHECK(std::abs(double(cell[k]) - expected) < 1e-5);
    }
}

TEST_CASE("Energies after a contact are known from its start") {
    StruckAtRest struck;
    constexpr double start = 3.5, contactSamples = 20; // the third mode swings 2.08 times
    const double contactSeconds = contactSamples / struck.sampleRateHz;
    struck.scratch.contact.setForced(struck.bank.poles(), {.contactSeconds = contactSeconds});
    struck.increments.start(-1, start);
    const float* after = struck.increments.energiesAfter(contactSeconds);
    struck.increments.finish(contactSeconds, start + contactSamples);
    struck.increments.joinAsleep(24, 1);
    for (std::size_t g = 0; g < 3; ++g)
        CHECK(std::abs(std::sqrt(double(after[g] / struck.bank.energies()[g])) - 1) < 0.03);
    CHECK(struck.increments.energiesAfter(0) == struck.increments.energies());
}

TEST_CASE("Increments that join a sleeping object move its resting states and leave them at rest") {
    StruckAtRest asleep, awake;
    std::array<float, cellSamples> cell{};
    for (StruckAtRest* struck : {&asleep, &awake}) {
        struck->residues.compute({}, {0, 0, -1}, {});
        struck->scratch.contact.setImpulse(struck->bank.poles());
        struck->increments.start(1, 10.25);
    }
    asleep.increments.joinAsleep(11, 1);
    awake.increments.soundAndKeep(11, cell);
    awake.increments.takeIn(1);
    for (std::size_t g = 0; g < 3; ++g) {
        CHECK(asleep.bank.state(g).x == awake.bank.state(g).x);
        CHECK(asleep.bank.state(g).y == awake.bank.state(g).y);
        CHECK(asleep.active.modes().rings(g));
    }
    CHECK(asleep.active.blocks().none());
    CHECK(asleep.active.restRinging());
    CHECK(asleep.active.demand().modes == 3);
    CHECK(!asleep.increments.pending());
}

TEST_CASE("A reset discards pending increments") {
    StruckAtRest struck;
    struck.strike(0);
    std::array<float, cellSamples> cell{};
    struck.increments.soundAndKeep(0, cell);
    struck.increments.reset();
    CHECK(!struck.increments.pending());
    struck.increments.takeIn(1);
    for (std::size_t g = 0; g < 3; ++g)
        CHECK(struck.bank.state(g).x == 0.0);
}
