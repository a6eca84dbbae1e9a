// Tests modes that are muted and unmuted.
#include "ModalReference.h"
#include "Synth/ModalResonator.h"

#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRate = 48000;
using Mask = std::vector<std::uint8_t>;

/// Sets the silenced modes to `maskAt` before each cell.
std::vector<float> played(const ModalObject& object,
                          const std::vector<TimedStrike>& strikes,
                          int cells,
                          const std::function<Mask(int cell)>& maskAt,
                          const SynthesisSettings& settings = exactSettings()) {
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    return render(synthesiser, strikes, cells, [&](int cell) {
        synthesiser.setSettings(settings);
        synthesiser.setSilencedModes(0, maskAt(cell));
    });
}

double errorDb(const std::vector<float>& sound,
               const std::vector<float>& expected,
               std::size_t fromSample = 0) {
    return test::errorDb(
        sound, [&](double n) { return double(expected[static_cast<std::size_t>(n)]); }, fromSample);
}

std::vector<float> force(Synthesiser& synthesiser, int cells, const BeforeCell& before) {
    std::vector<float> output;
    std::array<float, cellSamples> cell{}, newtons{};
    for (int c = 0; c < cells; ++c) {
        before(c);
        synthesiser.beginCell(cell);
        for (std::size_t k = 0; k < cellSamples; ++k)
            newtons[k] = static_cast<float>(
                std::sin(2 * std::numbers::pi * 480 * (c * cellSamples + double(k)) / sampleRate));
        synthesiser.applyForce(0, {.contact = 0, .start = {}, .end = {}, .newtons = newtons}, cell);
        output.insert(output.end(), cell.begin(), cell.end());
    }
    return output;
}

} // namespace

TEST_CASE("A mode silenced before the strike sounds as if the object lacked it") {
    const double contactSeconds = GENERATE(0.0, 1e-3);
    const auto strikes = std::vector<TimedStrike>{{5.5, unitStrike(contactSeconds)}};
    const auto none = [](int) { return Mask(); };
    SECTION("a separate mode") {
        const auto without = played(ringingObject({300, 1600}), strikes, 100, none);
        const auto silenced = played(ringingObject({300, 810, 1600}), strikes, 100, [](int) {
            return Mask{0, 1, 0};
        });
        CHECK(errorDb(silenced, without) < -115);
    }
    SECTION("one mode of a merged group") {
        const auto without =
            played(ringingObject({300, 810, 810}, 0.5, {1, 0.4f, 0.7f}), strikes, 100, none);
        const auto silenced = played(
            ringingObject({300, 810, 810, 810}, 0.5, {1, 0.4f, 0.9f, 0.7f}), strikes, 100, [](int) {
                return Mask{0, 0, 1, 0};
            });
        CHECK(errorDb(silenced, without) < -115);
    }
}

TEST_CASE("A silenced mode rings on and returns at its current state") {
    const ModalObject object = ringingObject({300, 810, 811, 1600}, 8);
    SynthesisSettings settings = exactSettings();
    settings.compression = GENERATE(0.0, 1.0);
    const auto strikes = std::vector<TimedStrike>{{0, unitStrike()}};
    const auto always = played(
        object, strikes, 200, [](int) { return Mask(); }, settings);
    const auto between = played(
        object, strikes, 200,
        [](int cell) {
            return cell >= 40 && cell < 120 ? Mask{1, 0, 1, 0} : Mask();
        },
        settings);
    CHECK(std::equal(between.begin(), between.begin() + 40 * cellSamples, always.begin()));
    CHECK(errorDb({between.begin() + 60 * cellSamples, between.begin() + 120 * cellSamples},
                  {always.begin() + 60 * cellSamples, always.begin() + 120 * cellSamples}) > -12);
    // Split groups moved with slightly different poles meanwhile.
    CHECK(errorDb(between, always, 125 * cellSamples) < (settings.compression > 0 ? -25 : -105));
}

TEST_CASE("Modes are silenced and return without a broadband sound, even during a contact") {
    const double contactSeconds = GENERATE(0.0, 0.025);
    const ModalObject object = ringingObject({200, 203, 310, 505, 812, 1230}, 4);
    SynthesisSettings settings = exactSettings();
    settings.compression = 1;
    settings.modeBudget = GENERATE(1e6, 3.0);
    const auto strikes = std::vector<TimedStrike>{{0, unitStrike(contactSeconds)}};
    auto sound = played(
        object, strikes, 160,
        [](int cell) {
            return Mask{std::uint8_t(cell / 5 % 2), 0, std::uint8_t(cell / 7 % 2), 0, 0,
                        std::uint8_t(cell / 9 % 2)};
        },
        settings);
    double peak = 0;
    for (const float sample : sound)
        peak = larger(peak, std::abs(double(sample)));
    sound.erase(sound.begin(), sound.begin() + 640); // the attack
    CHECK(broadbandDb(sound, sampleRate) - 20 * std::log10(peak) < -75);
}

TEST_CASE("Modes are silenced and return without a broadband sound during a force") {
    const auto broadband = [](bool comeAndGo) {
        Synthesiser synthesiser({slotOf(ringingObject({200, 310, 505, 812}, 30))}, sampleRate);
        synthesiser.setSettings(exactSettings());
        auto sound = force(synthesiser, 160, [&](int cell) {
            const auto is = static_cast<std::uint8_t>(comeAndGo && cell / 6 % 2 == 1);
            synthesiser.setSilencedModes(0, Mask{0, is, 0, is});
        });
        double peak = 0;
        for (const float sample : sound)
            peak = larger(peak, std::abs(double(sample)));
        return broadbandDb(sound, sampleRate) - 20 * std::log10(peak);
    };
    const double still = broadband(false), moving = broadband(true);
    CAPTURE(still, moving);
    CHECK(moving < -75);
}

TEST_CASE("Silencing no mode changes no bit, and the same masks give the same bits") {
    const ModalObject object = ringingObject({200, 203, 310, 505, 812, 1230}, 4);
    const auto strikes =
        std::vector<TimedStrike>{{0, unitStrike(1e-3)}, {2000.5, unitStrike(2e-3)}};
    Synthesiser untouched({slotOf(object)}, sampleRate);
    untouched.setSettings(exactSettings());
    CHECK(render(untouched, strikes, 80) ==
          played(object, strikes, 80, [](int) { return Mask(6, 0); }));
    const auto some = [](int cell) { return cell > 20 ? Mask{0, 1, 1, 0, 0, 0} : Mask(); };
    CHECK(played(object, strikes, 80, some) == played(object, strikes, 80, some));
    CHECK(played(object, strikes, 80, some) !=
          played(object, strikes, 80, [](int) { return Mask(); }));
}

TEST_CASE("A mask of the wrong length and a mask for a missing slot are ignored") {
    Synthesiser synthesiser({slotOf(ringingObject({300, 810}))}, sampleRate);
    synthesiser.setSilencedModes(0, Mask{1});
    synthesiser.setSilencedModes(0, Mask{1, 1, 1});
    synthesiser.setSilencedModes(7, Mask{1, 1});
    const auto sound = render(synthesiser, {{0, unitStrike()}}, 4);
    CHECK(synthesiser.status()[0].modesMixed == 2);
    CHECK(std::ranges::any_of(sound, [](float sample) { return sample != 0; }));
}

TEST_CASE("An object with every mode silenced is silent and uses no budget") {
    Synthesiser synthesiser({slotOf(ringingObject({300, 810}))}, sampleRate);
    synthesiser.setSilencedModes(0, Mask{1, 1});
    const auto sound = render(synthesiser, {{0, unitStrike(1e-3)}}, 10);
    CHECK(std::ranges::all_of(sound, [](float sample) { return sample == 0; }));
    CHECK(synthesiser.modesMixed() == 0);
}

TEST_CASE("A report gives the state and level of every group") {
    const ModalObject object = ringingObject({300, 810, 810, 1600, 30000}, 8);
    Synthesiser synthesiser({slotOf(object)}, sampleRate);
    SynthesisSettings settings = exactSettings();
    settings.tau = 0.01;
    settings.modeBudget = 1;
    synthesiser.setSettings(settings);
    synthesiser.setSilencedModes(0, Mask{0, 0, 0, 1, 0});
    Strike strike = unitStrike();
    std::array<float, cellSamples> cell{};
    synthesiser.beginCell(cell);
    synthesiser.strike(0, strike, 0, cell);
    for (int c = 0; c < 100; ++c)
        synthesiser.beginCell(cell);
    SoundingGroups groups(8);
    synthesiser.report(0, groups);
    REQUIRE(groups.count == 4);
    CHECK(groups.starts[1] == 1);
    CHECK(groups.starts[2] == 3);
    CHECK(groups.starts[4] == 5);
    CHECK(groups.standings[0] == GroupStanding::beyondBudget);
    CHECK(groups.standings[1] == GroupStanding::sounding);
    CHECK(groups.standings[2] == GroupStanding::silenced);
    CHECK(groups.standings[3] == GroupStanding::outOfBand);
    // A unit impulse on 1 kg moves each mode of gain 1 at 1 m/s; d = 8/s leaves e^{−4t} of it.
    const double left = std::exp(-4 * 100.0 * cellSamples / sampleRate);
    CHECK(std::abs(groups.amplitudes[0] / left - 1) < 0.01);
    CHECK(std::abs(groups.amplitudes[1] / (2 * left) - 1) < 0.01);
    CHECK(std::abs(groups.amplitudes[2] / left - 1) < 0.01);
    CHECK_FALSE(groups.groupsAreBehind);
    CHECK(synthesiser.status()[0].share == 1);
    CHECK(synthesiser.status()[0].groups == 4);
    CHECK(synthesiser.status()[0].groupsAudible == 2);

    settings.tau = 1e9;
    synthesiser.setSettings(settings);
    for (int c = 0; c < 100; ++c)
        synthesiser.beginCell(cell);
    synthesiser.report(0, groups);
    CHECK(groups.standings[1] == GroupStanding::belowTau);
    const double later =
        std::exp(-4 * 200.0 * cellSamples / sampleRate); // the block rests and decays
    CHECK(std::abs(groups.amplitudes[1] / (2 * later) - 1) < 0.01);

    SoundingGroups small(2);
    synthesiser.report(0, small);
    CHECK(small.count == 1);
}
