#include "Instrument/StrikeScheduler.h"
#include "Instrument/HeldContacts.h"
#include "Support/Level.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

/// A scheduler over cells of the bars, one for all slots.
struct Rig {
    explicit Rig(std::uint64_t seed = 1) : scheduler(*instrument, seed) {
        parameters.set(ParameterId::strikeSpread, 50);
    }

    void beginCell() {
        synthesiser.beginCell(samples);
        ++index;
    }
    StrikeMoment at(double sample, double softness = 1) {
        return {.cell = {synthesiser, cells, index},
                .sample = sample,
                .values = parameters,
                .softness = softness};
    }
    void strikeKey(double sample, double softness = 1) {
        scheduler.strikeKey(instrument->key(69), 100, HeldContacts::controllerAtRest,
                            at(sample, softness));
    }
    /// Finishes the cell and `count` − 1 more.
    std::vector<float> sound(int count = 1) {
        std::vector<float> result;
        for (int cell = 0; cell < count; ++cell) {
            if (cell > 0)
                beginCell();
            scheduler.strikeBefore(cellSamples, at(0).cell);
            result.insert(result.end(), samples.begin(), samples.end());
        }
        return result;
    }

    std::shared_ptr<const Instrument> instrument = bars();
    ParameterValues parameters;
    Synthesiser synthesiser{{instrument->slots().begin(), instrument->slots().end()}, sampleRateHz};
    alignas(64) std::array<float, cellSamples> samples{};
    std::vector<CellOutput> cells = std::vector<CellOutput>(instrument->slots().size(), samples);
    std::int64_t index = -1;
    StrikeScheduler scheduler;
};

} // namespace

TEST_CASE("A scheduled strike sounds from its sample on") {
    Rig rig;
    rig.beginCell();
    rig.strikeKey(40);
    CHECK_FALSE(rig.scheduler.silent());
    const auto sound = rig.sound(20);
    CHECK(std::all_of(sound.begin(), sound.begin() + 40, [](float x) { return x == 0; }));
    CHECK(peak(std::span(sound).subspan(40)) > 0);
    CHECK(rig.scheduler.silent());
}

TEST_CASE("A strike for the next cell waits for it") {
    Rig rig;
    rig.beginCell();
    rig.strikeKey(cellSamples);
    CHECK(peak(rig.sound()) == 0);
    rig.beginCell();
    CHECK(peak(rig.sound(20)) > 0);
}

TEST_CASE("A strike is the same for the same number and seed, and differs if either differs") {
    const auto struck = [](std::uint64_t seed, std::uint32_t number) {
        Rig rig(seed);
        rig.scheduler.countFrom(number);
        rig.beginCell();
        rig.strikeKey(0);
        return rig.sound(10);
    };
    CHECK(struck(1, 5) == struck(1, 5));
    CHECK(struck(1, 5) != struck(1, 6));
    CHECK(struck(1, 5) != struck(2, 5));
    Rig rig;
    rig.scheduler.countFrom(5);
    rig.scheduler.reset();
    rig.beginCell();
    rig.strikeKey(0);
    CHECK(rig.sound(10) == struck(1, 0));
}

TEST_CASE("A softer hand strikes more quietly") {
    Rig soft, hard;
    for (auto* rig : {&soft, &hard})
        rig->beginCell();
    soft.strikeKey(0, 0.5);
    hard.strikeKey(0);
    CHECK(rms(soft.sound(20)) < 0.8 * rms(hard.sound(20)));
}

TEST_CASE("The number of waiting surface strikes is limited, and a cleared strike never sounds") {
    Rig rig;
    const auto& key = rig.instrument->key(69);
    const SurfaceStrike click{.slot = static_cast<std::size_t>(key.slot),
                              .point = key.strip->between(key.along, 0).point,
                              .velocity = 100};
    int kept = 0;
    while (kept < 1000 && rig.scheduler.keep(click))
        ++kept;
    CHECK(kept == 64);
    rig.beginCell();
    rig.scheduler.clear();
    CHECK_FALSE(rig.scheduler.hasSurfaceStrikes());
    rig.scheduler.strikeSurfaces(rig.at(0));
    CHECK(peak(rig.sound(20)) == 0);
    REQUIRE(rig.scheduler.keep(click));
    rig.beginCell();
    rig.scheduler.strikeSurfaces(rig.at(0));
    CHECK_FALSE(rig.scheduler.hasSurfaceStrikes());
    CHECK(peak(rig.sound(20)) > 0);
}
