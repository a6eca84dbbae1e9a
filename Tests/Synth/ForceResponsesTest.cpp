#include "ResonatorParts.h"

#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// Applies an impulse in a cell and returns its sound.
std::array<float, cellSamples>
pushed(ForceResponses& forces, std::int64_t cell, const Listening& listening = {}) {
    std::array<float, cellSamples> newtons{}, sound{};
    newtons[0] = 48000;
    forces.begin(cell, listening);
    const ForceCell force{.start = {}, .end = {}, .newtons = newtons};
    HeardForce heard;
    forces.hear(force, heard);
    forces.add(heard, force, 0, cellSamples, sound);
    forces.moveAsHeard(force);
    return sound;
}

} // namespace

TEST_CASE("A response is cached until it is invalidated or the mixed modes change") {
    ResonatorParts parts(ringingObject({440, 700}, 20));
    ForceResponses forces(parts.bank, parts.output, parts.active, parts.residues, parts.scratch);
    parts.active.join({parts.bank.poles().audibleWeights(), 0, parts.bank.energies()}, 1, false, 1);
    const auto first = pushed(forces, 0);
    CHECK(first[10] != 0.0f);
    CHECK(forces.actedIn(0));
    CHECK(!forces.actedIn(1));
    const auto& cached = parts.scratch.responses[0][0];
    const std::uint64_t version = cached.version;
    CHECK(pushed(forces, 1) == first);
    CHECK(cached.version == version);
    CHECK(parts.scratch.responses[0][1].owner == nullptr);
    parts.active.join({parts.bank.poles().audibleWeights(), 0, parts.bank.energies()}, 2, false, 2);
    CHECK(pushed(forces, 2) != first);
    forces.invalidate();
    pushed(forces, 3);
    CHECK(parts.scratch.responses[0][2].owner == &forces);
}

TEST_CASE("A change of listening is interpolated over the cell") {
    ResonatorParts parts(ringingObject({440}, 20));
    ForceResponses forces(parts.bank, parts.output, parts.active, parts.residues, parts.scratch);
    parts.active.join({parts.bank.poles().audibleWeights(), 0, parts.bank.energies()}, 1, false, 1);
    const auto before = pushed(forces, 0);
    const auto changing = pushed(forces, 1, {.nearGain = 2});
    const auto after = pushed(forces, 2, {.nearGain = 2});
    CHECK(std::abs(double(after[40]) - 2 * double(before[40])) <
          1e-4 * std::abs(double(after[40])));
    CHECK(std::abs(changing[40]) > std::abs(before[40]));
    CHECK(std::abs(changing[40]) < std::abs(after[40]));
}
