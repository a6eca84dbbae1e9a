// Tests pedals: when they end, what they soften, and that another player takes them over.
#include "HeldKeys.h"
#include "Instrument/Player.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <span>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;
constexpr int sustain = 64, sostenuto = 66, soft = 67;

ParameterValues damped() {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.05);
    parameters.set(ParameterId::strikeSpread, 0);
    return parameters;
}

/// Returns whether a key still rings 0.2 s after its release; `pedal` goes down before the release.
bool ringsAfterRelease(Player& player, int pedal = 0) {
    std::vector events{midi(0, 0x90, 69, 100), midi(500, 0x80, 69, 0)};
    if (pedal != 0)
        events.insert(events.begin() + 1, midi(100, 0xb0, pedal, 127));
    const auto sound = render(player, events, 9600, 480, damped());
    return rms(std::span(sound).last(480)) > 1e-2 * rms(std::span(sound).first(480));
}

void send(Player& player, const std::vector<MidiEvent>& events) {
    render(player, events, 64, 64, damped());
}

} // namespace

TEST_CASE("Reset All Controllers and a reset lift the pedals, which can go down again") {
    const int pedal = GENERATE(sustain, sostenuto);
    const bool byMessage = GENERATE(true, false);
    CAPTURE(pedal, byMessage);
    Player player(bars(), sampleRateHz);
    send(player, {midi(0, 0xb0, pedal, 127)});
    if (byMessage)
        send(player, {midi(0, 0xb0, 121, 0)});
    else
        player.reset();
    CHECK_FALSE(ringsAfterRelease(player));
    CHECK(ringsAfterRelease(player, pedal));
}

TEST_CASE("Pedals keep their positions when another player takes over") {
    Player former(bars(), sampleRateHz);
    SECTION("sustain") {
        send(former, {midi(0, 0xb0, sustain, 127)});
        Player next(bars(), sampleRateHz);
        next.takeControllersOf(former);
        CHECK(ringsAfterRelease(next));
    }
    SECTION("sostenuto, which holds no key that goes down later") {
        send(former, {midi(0, 0xb0, sostenuto, 127)});
        Player next(bars(), sampleRateHz);
        next.takeControllersOf(former);
        CHECK_FALSE(ringsAfterRelease(next, sostenuto));
    }
    SECTION("soft") {
        send(former, {midi(0, 0xb0, soft, 100)});
        Player next(bars(), sampleRateHz), same(bars(), sampleRateHz), hard(bars(), sampleRateHz);
        next.takeControllersOf(former);
        const auto key = midi(0, 0x90, 69, 100);
        const auto played = render(next, {key}, 4800, 480, damped());
        CHECK(played == render(same, {midi(0, 0xb0, soft, 100), key}, 4800, 480, damped()));
        CHECK(played != render(hard, {key}, 4800, 480, damped()));
    }
}

TEST_CASE("The soft pedal halves the pressure with which a key begins to scrape") {
    const auto scraped = [](int pedal, int velocity) {
        return play(shortBars(), {midi(0, 0xb0, soft, pedal), midi(0, 0x90, 60, velocity)}, 9600);
    };
    CHECK(rms(scraped(127, 126)) < 0.8 * rms(scraped(0, 126)));
    CHECK(rms(scraped(127, 126)) == Approx(rms(scraped(0, 63))).epsilon(1e-6));
}
