// Tests a player's motor: the modes that bars share with their tubes pulse for every contact, and
// nothing else does.
#include "BusyKeys.h"
#include "Instrument/Motor.h"
#include "SameInAllBlocks.h"
#include "Support/Level.h"
#include "TestInstruments.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <catch2/matchers/catch_matchers_floating_point.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Matchers::WithinAbs;
using enum ParameterId;

namespace {

constexpr double sampleRateHz = 48000;
constexpr int key = 66;

/// Keys 60 to 72. Each bar shares its fundamental with its tube as a pair of modes, which only the
/// tube radiates, and has two further modes.
std::shared_ptr<const Instrument> barsOverTubes(bool withTubes = true) {
    auto bar = syntheticObject({440, 446, 1500, 2700}, {0.7f, 0.7f, 1, 1});
    if (withTubes)
        bar.gains = {{2, 0.5f}, {-1, -0.5f}, 1, 1};
    bar.radiation = {.directions = {{-0.6f, 0, 0.8f}, {0.6f, 0, 0.8f}},
                     .frequencyRatios = {1},
                     .weights = {0.2f, -0.2f, 0.3f, 0.2f, 0.1f, -0.1f, -0.2f, 0.3f}};
    return keysOn(std::move(bar), KeyMapKind::scaled, 60, 72);
}

ParameterValues turning(double depthPercent) {
    ParameterValues parameters;
    parameters.set(motorSpeed, 1);
    parameters.set(motorDepth, depthPercent);
    return parameters;
}

/// Returns the sound of a key held for a second.
StereoSound heldKey(const ParameterValues& parameters,
                    std::vector<std::uint8_t> silenced = {0, 0, 0, 0}) {
    const auto instrument = barsOverTubes();
    Player player(instrument, sampleRateHz);
    player.setSilencedModes(
        {.objects = {{instrument->slots().front().object.get(), std::move(silenced)}}});
    return renderStereo(player, {midi(20, 0x90, key, 100)}, 48000, 480, parameters);
}

} // namespace

TEST_CASE("The motor multiplies only the modes shared with tubes by the opening of its discs") {
    const double how = GENERATE(strikeContact, scrapeContact, rollContact);
    const double radiates = GENERATE(0, 100);
    CAPTURE(how, radiates);
    auto still = turning(0), turns = turning(100);
    for (auto* parameters : {&still, &turns}) {
        parameters->set(contact, how);
        parameters->set(radiation, radiates);
        parameters->set(tau, parameterInfo(tau).minimum);
    }
    const auto heard = heldKey(turns);
    const auto shared = heldKey(still, {0, 0, 1, 1}), own = heldKey(still, {1, 1, 0, 0});
    REQUIRE(peak(shared.left) > 1e-6f);
    REQUIRE(peak(own.left) > 1e-6f);

    Motor motor(cellSamples / sampleRateHz);
    float farthest = 0;
    for (std::size_t start = 0; start < heard.left.size(); start += cellSamples) {
        const float before = motor.gain();
        const float way = motor.advance(1, 1) - before;
        for (std::size_t k = 0; k < cellSamples; ++k) {
            const float gain = before + way * static_cast<float>(k + 1) / cellSamples;
            for (const auto side : {&StereoSound::left, &StereoSound::right}) {
                const auto at = [&](const StereoSound& sound) { return (sound.*side)[start + k]; };
                farthest = std::max(farthest, std::abs(at(heard) - at(own) - gain * at(shared)));
            }
        }
    }
    CHECK(farthest < 3e-6f * (peak(shared.left) + peak(own.left)));
}

TEST_CASE("A fundamental falls to the gain of closed discs, and returns when they open") {
    const double depthPercent = GENERATE(45.0, 90.0);
    const std::vector<std::uint8_t> fundamental{0, 0, 1, 1};
    const auto turns = heldKey(turning(depthPercent), fundamental);
    const auto still = heldKey(turning(0), fundamental);
    const auto dbAt = [&](double seconds) { // within 5 ms, in which the discs hardly move
        const auto around = [&](const StereoSound& sound) {
            const auto first = static_cast<std::size_t>((seconds - 0.0025) * sampleRateHz);
            return rms(std::span(sound.left).subspan(first, 240));
        };
        return 20 * std::log10(around(turns) / around(still));
    };
    const double closedDb = 20 * std::log10(1 - depthPercent / 100);
    CHECK_THAT(dbAt(0.25), WithinAbs(closedDb, 0.1)); // open twice a turn
    CHECK_THAT(dbAt(0.5), WithinAbs(0, 0.1));
    CHECK_THAT(dbAt(0.75), WithinAbs(closedDb, 0.1));
}

TEST_CASE("A motor without depth, or under bars without tubes, changes no bit") {
    auto fast = turning(0);
    fast.set(motorSpeed, 12);
    CHECK(heldKey(fast) == heldKey({}));

    const auto events = busyEvents(20000);
    const auto played = [&](const ParameterValues& parameters) {
        Player player(barsOverTubes(false), sampleRateHz);
        return renderStereo(player, events, 20000, 480, parameters);
    };
    CHECK(played(turning(100)) == played(turning(0)));
}

TEST_CASE("With a motor renders are bit-identical for block sizes 1, 7, 64, 480 and 960") {
    auto events = busyEvents(20000);
    for (auto& event : events) // some of the events become All Sound Off
        if (event.bytes[0] == 0xe0 && event.bytes[2] < 40)
            event.bytes = {0xb0, 120, 0};
    auto parameters = turning(80);
    parameters.set(motorSpeed, 9);
    parameters.set(letRing, 0);
    parameters.set(radiation, 60);
    parameters.set(contact, GENERATE(strikeContact, rollContact));
    const auto sound = checkSameInBlocksOf({1, 7, 64, 480, 960}, barsOverTubes(), sampleRateHz,
                                           events, 20000, parameters);
    CHECK(peak(sound.left) > 1e-5f);
}
