#include "ModalReference.h"
#include "Support/RigidBall.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <random>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;
constexpr double allModes = 1e6;

std::vector<SynthesiserSlot> loudAndQuiet() {
    return {slotOf(ringingObject({310, 505, 812, 1230}, 3)),
            slotOf(ringingObject({260, 440, 705, 1110}, 2))};
}

Strike strikeOf(float newtonSeconds, double durationSeconds = 0) {
    Strike strike = unitStrike(durationSeconds);
    strike.impulseNewtonSeconds = {0, 0, -newtonSeconds};
    return strike;
}

using Change = std::function<void(int cell, SynthesisSettings&, Synthesiser&)>;

/// Plays the objects under a budget that lets the quiet one sleep from cell 4 to cell `wakesAt`.
std::vector<float> played(const std::vector<TimedStrike>& strikes,
                          int cells,
                          double budget,
                          int wakesAt,
                          const Change& change = {}) {
    Synthesiser synthesiser(loudAndQuiet(), sampleRate);
    SynthesisSettings settings = exactSettings();
    return render(synthesiser, strikes, cells, [&](int cell) {
        settings.modeBudget = cell >= 4 && cell < wakesAt ? budget : allModes;
        if (change)
            change(cell, settings, synthesiser);
        synthesiser.setSettings(settings);
        if (cell == wakesAt)
            CHECK(synthesiser.status()[1].modesMixed == (budget < 8 ? 0 : 4));
    });
}

double
differenceDb(const std::vector<float>& sound, const std::vector<float>& expected, int fromCell) {
    return errorDb(
        sound, [&](double sample) { return double(expected[static_cast<std::size_t>(sample)]); },
        static_cast<std::size_t>(fromCell) * cellSamples);
}

} // namespace

TEST_CASE("An object that wakes sounds as if it had never slept") {
    std::vector<TimedStrike> strikes{{3, strikeOf(1), 0}, {10.5, strikeOf(0.5f), 1}};
    Change change;
    SECTION("after nothing else") {}
    SECTION("after quiet strikes in its sleep") {
        strikes.push_back({1000.25, strikeOf(0.02f), 1});
        strikes.push_back({1001.75, strikeOf(0.03f, 0.3e-3), 1});
        strikes.push_back({1500, strikeOf(0.03f, 5e-3), 1});
    }
    SECTION("after a damper, a bend and another material") {
        change = [](int cell, SynthesisSettings& settings, Synthesiser& synthesiser) {
            synthesiser.setDamping(1, cell >= 30 && cell < 50 ? 4 : 0);
            synthesiser.setFrequencyRatio(1, cell >= 20 && cell < 45 ? 1.02 : 1);
            settings.sizeRatio = cell >= 25 && cell < 35 ? 1.1 : 1;
        };
    }
    constexpr int wakesAt = 60, settled = wakesAt + 6;
    const auto slept = played(strikes, 120, 4, wakesAt, change);
    const auto awake = played(strikes, 120, allModes, wakesAt, change);
    CHECK(differenceDb(slept, awake, settled) < -105);
    // It was not heard in its sleep.
    const std::vector<float> start(awake.begin(), awake.begin() + 55 * cellSamples);
    CHECK(differenceDb({slept.begin(), slept.begin() + 55 * cellSamples}, start, 40) > -30);
}

TEST_CASE("The loudest object sounds at once when it is struck in its sleep") {
    const std::vector<TimedStrike> strikes{
        {3, strikeOf(1), 0}, {10.5, strikeOf(0.5f), 1}, {40 * 64 + 20.5, strikeOf(20), 1}};
    Synthesiser synthesiser(loudAndQuiet(), sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.modeBudget = 4;
    synthesiser.setSettings(settings);
    const auto output = render(synthesiser, strikes, 50);
    const auto full = played(strikes, 50, allModes, 40);
    // The other object fades out, 26 dB below.
    const auto from = output.begin() + 41 * cellSamples;
    CHECK(differenceDb({from, output.end()}, {full.begin() + 41 * cellSamples, full.end()}, 0) <
          -20);
    CHECK(synthesiser.status()[1].modesMixed == 4);
    CHECK(synthesiser.status()[0].modesMixed == 0);
}

TEST_CASE("A budget that suffices changes no bit") {
    const auto play = [](double budget) {
        Synthesiser synthesiser(loudAndQuiet(), sampleRate);
        SynthesisSettings settings = exactSettings();
        settings.modeBudget = budget;
        synthesiser.setSettings(settings);
        return render(synthesiser,
                      {{3, strikeOf(1), 0}, {400, strikeOf(0.1f, 2e-3), 1}, {900, strikeOf(2), 1}},
                      100);
    };
    CHECK(play(8) == play(allModes));
    CHECK(play(7) != play(allModes));
}

TEST_CASE("Strikes in a crowd never mix more than the budget in the cells that follow") {
    std::vector<SynthesiserSlot> slots;
    for (int k = 0; k < 60; ++k)
        slots.push_back(slotOf(ringingObject({300.0 + k, 505, 812, 1230, 2200, 3300}, 4)));
    const double slope = GENERATE(0.0, 1.0, 10.0);
    std::minstd_rand random(5);
    std::vector<TimedStrike> strikes;
    for (int k = 0; k < 400; ++k)
        strikes.push_back({40.0 * k, strikeOf(0.01f * static_cast<float>(1 + random() % 100)),
                           random() % slots.size()});
    Synthesiser synthesiser(slots, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.tau = 1;
    settings.modeBudget = 50;
    settings.qualitySlope = slope;
    synthesiser.setSettings(settings);
    std::int64_t most = 0;
    render(synthesiser, strikes, 260,
           [&](int) { most = std::max(most, synthesiser.modesMixed()); });
    CHECK(most == 50);
    CHECK(!synthesiser.silent());
    settings.tau = 1e9;
    synthesiser.setSettings(settings);
    render(synthesiser, {}, 60);
    CHECK(synthesiser.silent());
}

TEST_CASE("The click of a sleeping object sounds") {
    const SynthesiserSlot ball = slotOf(rigidBall(0.01, 7000));
    const TimedStrike loud{3, strikeOf(1), 0};
    const TimedStrike quiet{400.25, strikeOf(1e-4f, 0.3e-3), 1};
    const auto play = [&](const std::vector<TimedStrike>& strikes, double budget) {
        Synthesiser synthesiser({loudAndQuiet()[0], ball}, sampleRate);
        SynthesisSettings settings = exactSettings();
        settings.modeBudget = budget;
        settings.radiation = 1;
        synthesiser.setSettings(settings);
        const auto sound = render(synthesiser, strikes, 12);
        CHECK(synthesiser.status()[1].modesMixed == 0);
        return sound;
    };
    const auto click = play({quiet}, allModes);
    CHECK(std::ranges::max(click) > 0);
    auto both = play({loud, quiet}, 2);
    const auto one = play({loud}, 2);
    for (std::size_t n = 0; n < both.size(); ++n)
        both[n] -= one[n];
    CHECK(differenceDb(both, click, 0) < -60);
}

TEST_CASE("A force wakes the object that it presses on") {
    Synthesiser synthesiser(loudAndQuiet(), sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.modeBudget = 4;
    synthesiser.setSettings(settings);
    render(synthesiser, {{3, strikeOf(1), 0}, {10.5, strikeOf(0.1f), 1}}, 20);
    REQUIRE(synthesiser.status()[1].modesMixed == 0);
    std::array<float, cellSamples> cell{}, newtons;
    newtons.fill(1);
    synthesiser.beginCell(cell);
    CHECK(synthesiser.applyForce(1, {.start = {}, .end = {}, .newtons = newtons}, cell));
    synthesiser.beginCell(cell);
    CHECK(synthesiser.status()[1].modesMixed == 2); // an equal share
}

TEST_CASE("A reset leaves no object asleep") {
    Synthesiser synthesiser(loudAndQuiet(), sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.modeBudget = 4;
    synthesiser.setSettings(settings);
    const std::vector<TimedStrike> strikes{{3, strikeOf(1), 0}, {10.5, strikeOf(0.5f), 1}};
    const auto first = render(synthesiser, strikes, 40);
    synthesiser.reset();
    CHECK(synthesiser.silent());
    CHECK(synthesiser.status()[1].modesRinging == 0);
    CHECK(render(synthesiser, strikes, 40) == first);
}
