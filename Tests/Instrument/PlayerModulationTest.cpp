// Tests what modulation does to the sound of a player.
#include "BusyKeys.h"
#include "SameInAllBlocks.h"
#include "Support/AllocationCounter.h"
#include "Support/Level.h"
#include "Support/Routes.h"
#include "Support/WithParameter.h"
#include "TestInstruments.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;
using enum ParameterId;

namespace {

constexpr double sampleRateHz = 48000;
constexpr std::size_t slotOf69 = 9, slotOf72 = 12;

/// Every source moves something: strikes, slots, all notes, and an amount.
ParameterValues everySource() {
    auto values = routed(0, ModulationSource::lfo1, size, 5);
    values = routed(1, ModulationSource::lfo2, tune, 10, values);
    values = routed(2, ModulationSource::envelope, decay, -20, values);
    values = routed(3, ModulationSource::velocity, malletHardness, 30, values);
    values = routed(4, ModulationSource::key, radiation, 30, values);
    values = routed(5, ModulationSource::pressure, releaseTime, -30, values);
    values = routed(6, ModulationSource::wheel, modulation2Amount, 5, values);
    values = routed(7, ModulationSource::random, strikeAlong, 50, values);
    values = with(with(values, lfo1Shape, double(LfoShape::square)), lfo1Rate, 9);
    values = with(with(values, lfo2Shape, double(LfoShape::random)), lfo2Rate, 20);
    values = with(with(values, lfo2PerNote, 1), letRing, 0);
    return with(with(values, releaseTime, 0.3), material, customMaterial);
}

std::vector<MidiEvent> busyWithPressure(int samples) {
    auto events = busyEvents(samples);
    for (std::size_t i = 0; i < events.size(); ++i)
        if (events[i].bytes[0] == 0xe0)
            events[i].bytes = i % 2 == 0 ? std::array<std::uint8_t, 3>{0xd0, events[i].bytes[2], 0}
                                         : std::array<std::uint8_t, 3>{0xb0, 1, events[i].bytes[2]};
    return events;
}

StereoSound played(const std::vector<MidiEvent>& events,
                   std::size_t samples,
                   const ParameterValues& parameters) {
    Player player(bars(), sampleRateHz);
    return renderStereo(player, events, samples, 480, parameters);
}

} // namespace

TEST_CASE("Settings of sources without a route change no bit") {
    const auto events = busyEvents(9600);
    auto idle = with(with(ParameterValues(), lfo1Rate, 20), envelopeAttack, 5);
    idle = routed(0, ModulationSource::lfo1, tune, 0, idle);
    idle = routed(1, ModulationSource::none, size, 100, idle);
    CHECK(played(events, 9600, idle) == played(events, 9600, {}));
}

TEST_CASE("Modulated renders are bit-identical for block sizes 1, 7, 64, 480 and 960") {
    const auto parameters = with(everySource(), contact, GENERATE(strikeContact, scrapeContact));
    const auto sound = checkSameInBlocksOf({1, 7, 64, 480, 960}, bars(), sampleRateHz,
                                           busyWithPressure(12000), 12000, parameters);
    CHECK(peak(sound.left) > 1e-5f);
    CHECK(sound != played(busyWithPressure(12000), 12000,
                          with(ParameterValues(), contact, parameters[contact])));
}

TEST_CASE("Modulation never allocates, with all routes and crowds of notes") {
    Player player(bars(), sampleRateHz);
    StereoSound output(480);
    auto events = busyWithPressure(480 * 20);
    for (auto& event : events)
        event.sampleOffset %= 480;
    std::ranges::sort(events, {}, &MidiEvent::sampleOffset);
    const auto parameters = everySource();
    const AllocationCounter counter;
    for (int block = 0; block < 20; ++block)
        player.process(output, events, parameters);
    CHECK(counter.allocations() == 0);
    CHECK(std::isfinite(peak(output.left)));
}

TEST_CASE("Each key has the pitch of its own velocity") {
    Player player(bars(), sampleRateHz);
    const auto parameters = routed(0, ModulationSource::velocity, tune, 10);
    renderStereo(player, {midi(0, 0x90, 69, 127), midi(1000, 0x90, 72, 64)}, 2000, 480, parameters);
    const auto semitones = [&](std::size_t slot) {
        return 12 * std::log2(player.synthesiser().frequencyRatio(slot));
    };
    CHECK(semitones(slotOf69) == Approx(2.4));
    CHECK(semitones(slotOf72) == Approx(2.4 * 64 / 127));
    renderStereo(player, {}, 200, 100, {}); // the route is gone
    CHECK(semitones(slotOf69) == 0);
}

TEST_CASE("An LFO on the level makes a tremolo of its rate and depth") {
    // 6 dB to both sides, four times a second.
    auto parameters = routed(0, ModulationSource::lfo1, level, 100 * 6.0 / 84);
    parameters = with(parameters, lfo1Rate, 4);
    const std::vector events{midi(0, 0x90, 69, 100)};
    const auto swinging = played(events, 24000, parameters), still = played(events, 24000, {});
    for (std::size_t at = 2400; at + 480 < 24000; at += 1200) {
        const double seconds = (static_cast<double>(at) + 240) / sampleRateHz;
        const auto around = [&](const StereoSound& sound) {
            return rms(std::span(sound.left).subspan(at, 480));
        };
        const double wantedDb = 6 * std::sin(2 * std::numbers::pi * 4 * (seconds - 0.013));
        CHECK(20 * std::log10(around(swinging) / around(still)) == Approx(wantedDb).margin(0.6));
    }
}

TEST_CASE("A synced LFO and random values repeat when a song begins again in silence") {
    auto parameters = routed(0, ModulationSource::random, malletHardness, 60);
    parameters = routed(1, ModulationSource::lfo1, tune, 10, parameters);
    parameters = with(parameters, lfo1Sync, *parseParameter(parameterInfo(lfo1Sync), "1/8"));
    parameters = with(with(parameters, letRing, 0), releaseTime, 0.005);
    const std::vector events{midi(100, 0x90, 69, 100), midi(2000, 0x80, 69, 0),
                             midi(3000, 0x90, 65, 90), midi(4000, 0x80, 65, 0)};
    Player player(bars(), sampleRateHz);
    const auto pass = [&](double beats) {
        player.setSong(120, beats);
        CHECK(player.beginSong());
        auto sound = renderStereo(player, events, 48000, 48000, parameters);
        player.setSong(120, std::nullopt);
        renderStereo(player, {}, 48000, 480, parameters);
        REQUIRE(player.silent());
        return sound;
    };
    const auto first = pass(8);
    CHECK(pass(8) == first);
    CHECK(pass(8.1) != first);
}

TEST_CASE("A click on an object has its own velocity as a source") {
    const auto parameters = routed(0, ModulationSource::velocity, tune, 10);
    Player player(bars(), sampleRateHz);
    const StrikePoint point;
    player.strikeSurface({.slot = slotOf69, .point = point, .velocity = 127});
    renderStereo(player, {}, 480, 480, parameters);
    CHECK(12 * std::log2(player.synthesiser().frequencyRatio(slotOf69)) == Approx(2.4));
}

TEST_CASE("A note sounds until its objects are silent") {
    const auto parameters = with(with(ParameterValues(), letRing, 0), releaseTime, 0.01);
    Player player(bars(), sampleRateHz);
    CHECK_FALSE(player.sounds(69));
    renderStereo(player, {midi(470, 0x90, 69, 100), midi(475, 0x80, 69, 0)}, 480, 480, parameters);
    CHECK(player.sounds(69));
    CHECK_FALSE(player.sounds(72));
    renderStereo(player, {}, 24000, 480, parameters);
    CHECK_FALSE(player.sounds(69));
}
