// Tests the sound of a player's strikes: channels, pitch, place and seed.
#include "Instrument/Player.h"
#include "BusyKeys.h"
#include "Instrument/ContactTrain.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/SettingsOfParameters.h"
#include "Support/Level.h"
#include "Support/PoleFit.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <set>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

} // namespace

TEST_CASE("Without radiation both channels are the sound at the struck point") {
    const auto instrument = bars();
    Player player(instrument, sampleRateHz);
    const auto sound = renderStereo(player, busyEvents(20000), 20000, 512);
    CHECK(sound.left == sound.right);

    // The slot of key 69, struck without a player.
    ParameterValues parameters;
    parameters.set(ParameterId::strikeSpread, 0);
    Player one(instrument, sampleRateHz);
    const auto played = renderStereo(one, {midi(0, 0x90, 69, 100)}, 2048, 512, parameters);
    const auto& key = instrument->key(69);
    Synthesiser mono({instrument->slots()[static_cast<std::size_t>(key.slot)]}, sampleRateHz);
    mono.setSettings(synthesisSettings(parameters));
    const auto strike =
        malletStrike(key.strip->between(key.along, 0).point, 100, key.mallet, parameters,
                     instrument->slots()[static_cast<std::size_t>(key.slot)]);
    ContactTrain impact;
    impact.add({.delaySeconds = 0, .strike = strike});
    std::vector<float> expected(2048);
    for (std::size_t at = 0; at < expected.size(); at += cellSamples) {
        alignas(64) std::array<float, cellSamples> cell{};
        mono.beginCell(cell);
        if (at == 0)
            for (const auto& part : withFilledNulls(impact))
                REQUIRE(mono.strike(0, part.strike, part.delaySeconds * sampleRateHz, cell));
        std::ranges::copy(cell, expected.begin() + static_cast<std::ptrdiff_t>(at));
    }
    CHECK(played.left == expected);
    CHECK(played.right == expected);
}

TEST_CASE("With radiation left and right differ, at the same pitch") {
    for (const double percent : {0.0, 30.0, 60.0, 100.0}) {
        ParameterValues parameters;
        parameters.set(ParameterId::radiation, percent);
        Player player(bars(), sampleRateHz);
        const auto sound = renderStereo(player, {midi(0, 0x90, 69, 100)}, 24000, 480, parameters);
        std::vector<float> side(sound.left.size());
        for (std::size_t i = 0; i < side.size(); ++i)
            side[i] = sound.left[i] - sound.right[i];
        const double apart = rms(side) / (rms(sound.left) + rms(sound.right));
        INFO(percent << " %: " << apart);
        CHECK((percent == 0 ? apart == 0 : apart > 0.001));
        for (const auto* channel : {&sound.left, &sound.right})
            CHECK(std::abs(cents(fitPole(*channel, sampleRateHz, 440, 0.05).frequencyHz, 440)) <
                  0.1);
    }
}

TEST_CASE(
    "If no pitch is kept, a library material moves every frequency by the root of E over density") {
    ParameterValues parameters;
    parameters.set(ParameterId::keepPitch, 0);
    parameters.set(ParameterId::material,
                   *parseParameter(parameterInfo(ParameterId::material), "Glass"));
    const auto* glass = findMaterial("Glass");
    const double expected =
        440 * std::sqrt(glass->youngsModulusPa / glass->densityKgPerM3 / (1e10 / 1000));
    Player player(bars(), sampleRateHz);
    const auto sound = render(player, {midi(0, 0x90, 69, 100)}, 24000, 256, parameters);
    CHECK(std::abs(cents(fitPole(sound, sampleRateHz, expected, 0.05).frequencyHz, expected)) <
          0.1);
}

TEST_CASE("Silence returns when all notes have decayed") {
    Player player(bars(), sampleRateHz);
    CHECK(player.silent());
    render(player, {midi(0, 0x90, 69, 100)}, 64, 64);
    CHECK_FALSE(player.silent());
    const auto tail = render(player, {}, 48000 * 12, 4096);
    CHECK(player.silent());
    CHECK(peak(std::span(tail).last(4800)) == 0);
}

TEST_CASE("Every key of the plate has its own strike place") {
    const auto instrument = plate();
    ParameterValues parameters;
    parameters.set(ParameterId::strikeSpread, 0);
    std::set<std::vector<float>> sounds;
    for (int note = 36; note <= 96; ++note) {
        Player player(instrument, sampleRateHz);
        sounds.insert(render(player, {midi(0, 0x90, note, 100)}, 2400, 480, parameters));
    }
    CHECK(sounds.size() == 61);
}

TEST_CASE("The seed affects only the spread and the chatter of strikes") {
    const auto plate =
        Instrument::build({.kind = KeyMapKind::zones, .object = "plate"}, ObjectLibrary::shared())
            .value();
    const auto sound = [&](std::uint64_t seed, ParameterId varied, double value) {
        ParameterValues parameters;
        parameters.set(ParameterId::strikeSpread, 0);
        parameters.set(ParameterId::mallet, firstRackMallet + 5);
        parameters.set(varied, value);
        const std::vector events{midi(0, 0x90, 64, 100), midi(900, 0x90, 71, 90)};
        Player player(plate, sampleRateHz, {}, seed);
        const auto first = render(player, events, 2400, 480, parameters);
        player.reset();
        CHECK(render(player, events, 2400, 480, parameters) == first);
        return first;
    };
    for (const auto& [varied, value] :
         {std::pair(ParameterId::chatter, 100.0), {ParameterId::strikeSpread, 50.0}}) {
        CHECK(sound(1, varied, value) != sound(2, varied, value));
        CHECK(sound(1, varied, 0) == sound(2, varied, 0));
    }
}
