#include "Instrument/Mutation.h"

#include "Instrument/FactoryContent.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/PhrasePrediction.h"
#include "Instrument/Player.h"
#include "Instrument/TestInstruments.h"
#include "Support/RenderNotes.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using enum ParameterId;

namespace {

std::shared_ptr<const Instrument> built(const Preset& preset) {
    return Instrument::build(preset.keyMap, ObjectLibrary::shared()).value();
}

const Preset& rosewood() {
    return *findFactoryPreset("Rosewood Xylophone");
}

ParameterValues mutatedRosewood(double strength, std::uint32_t seed) {
    return mutated(rosewood().parameters, built(rosewood()), rosewood(), strength, seed);
}

} // namespace

TEST_CASE("The same seed gives the same mutation, and another seed gives another") {
    CHECK(mutatedRosewood(0.5, 7) == mutatedRosewood(0.5, 7));
    CHECK_FALSE(mutatedRosewood(0.5, 7) == mutatedRosewood(0.5, 8));
}

TEST_CASE("A mutation of zero strength or without an instrument changes nothing") {
    CHECK(mutatedRosewood(0, 3) == rosewood().parameters);
    CHECK(mutatedRosewood(std::nan(""), 3) == rosewood().parameters);
    CHECK(mutated(rosewood().parameters, nullptr, rosewood(), 1, 3) == rosewood().parameters);
}

TEST_CASE("A mutation changes the sound but keeps pitch, quality and bypass") {
    std::set<ParameterId> mayMove{material, mallet, level, youngsModulus, density};
    for (const auto& info : parameterTable())
        if (info.mutation.step > 0)
            mayMove.insert(info.parameter);
    for (const auto kept : {tune, concertPitch, bypass, size, thickness, tau, qualitySlope,
                            modeBudget, compression, bendRange, letRing, contact, matchLoudness})
        CHECK_FALSE(mayMove.contains(kept));
    const auto next = mutatedRosewood(1, 5);
    for (const auto& info : parameterTable()) {
        INFO(info.id);
        if (!mayMove.contains(info.parameter))
            CHECK(next[info.parameter] == rosewood().parameters[info.parameter]);
    }
    // The custom material replaces the bars' own with its stiffness and density, so the pitch
    // stays the same.
    const auto& own = built(rosewood())->slots().front().object->material;
    CHECK(next[material] == double{customMaterial});
    CHECK(next[youngsModulus] == Approx(own.youngsModulusPa / 1e9));
    CHECK(next[density] == Approx(own.densityKgPerM3));
}

TEST_CASE("Every step stays within its share of the range and within musical bounds") {
    const auto start = mutatedRosewood(1e-12, 1); // with the current figures
    for (std::uint32_t seed = 0; seed < 40; ++seed) {
        const auto next = mutatedRosewood(0.3, seed);
        for (const auto& info : parameterTable()) {
            const auto& range = info.mutation;
            if (range.step == 0)
                continue;
            INFO(info.id);
            const double from = start[info.parameter], to = next[info.parameter];
            CHECK(std::abs(info.toNormalised(to) - info.toNormalised(from)) <=
                  0.3 * range.step + 1e-9);
            CHECK(to >= std::min(range.lowest, from) - 1e-9);
            CHECK(to <= std::max(range.highest, from) + 1e-9);
        }
    }
}

TEST_CASE("A hundred mutations of mutations stay within the bounds") {
    const auto instrument = built(rosewood());
    auto now = rosewood().parameters;
    for (std::uint32_t seed = 0; seed < 100; ++seed)
        now = mutated(now, instrument, rosewood(), 1, seed);
    for (const auto& info : parameterTable()) {
        const auto [step, lowest, highest] = info.mutation;
        if (step == 0)
            continue;
        INFO(info.id);
        CHECK(now[info.parameter] >= lowest * (lowest > 0 ? 0.999 : 1.001));
        CHECK(now[info.parameter] <= highest * 1.001);
    }
    CHECK(now[level] <= 0);
}

TEST_CASE("A mutation is as loud as its origin within the level's reach, and never louder") {
    for (const auto* name : {"Rosewood Xylophone", "Steel Plate", "Handbell"}) {
        const auto& preset = *findFactoryPreset(name);
        const auto instrument = built(preset);
        const Phrase phrase(instrument, preset.surface, 48000);
        const auto loudness = [&](const ParameterValues& values) {
            return predictedLufs(phrase, values) + values[level];
        };
        for (std::uint32_t seed = 0; seed < 6; ++seed) {
            INFO(name << ", seed " << seed);
            const auto next = mutated(preset.parameters, instrument, preset, 1, seed);
            const double louder = loudness(next) - loudness(preset.parameters);
            CHECK(louder <= 0.01);
            CHECK(next[level] <= preset.parameters[level] + 6.01);
            if (next[level] < preset.parameters[level] + 5.9 && next[level] < -0.1)
                CHECK(louder >= -0.01);
        }
    }
}

TEST_CASE("No mutation of a factory preset struck hard exceeds full scale") {
    for (const auto* name : {"Rosewood Xylophone", "Glockenspiel", "Ammunition Shell"}) {
        const auto& preset = *findFactoryPreset(name);
        const auto instrument = built(preset);
        const int note = (preset.keyMap.lowestNote + preset.keyMap.highestNote) / 2;
        for (std::uint32_t seed = 0; seed < 12; ++seed) {
            const auto next = mutated(preset.parameters, instrument, preset, 1, seed);
            Player player(instrument, 48000, preset.surface, preset.seed, preset.parameters);
            const auto sound = render(player, {midi(0, 0x90, note, 127)}, 24000, 512, next);
            float peak = 0;
            for (const float sample : sound)
                peak = std::max(peak, std::abs(sample));
            INFO(name << ", seed " << seed);
            CHECK(peak * std::pow(10, next[level] / 20) < 1);
            CHECK(peak > 0);
        }
    }
}
