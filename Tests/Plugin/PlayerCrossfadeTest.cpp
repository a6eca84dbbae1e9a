#include "Plugin/PlayerCrossfade.h"

#include "Plugin/ObjectEmbedding.h"
#include "Support/TestSound.h"

#include <catch2/catch_test_macros.hpp>
#include <numbers>

using namespace idiophone;
using namespace idiophone::test;

namespace {

const auto fadeSamples = static_cast<std::size_t>(PlayerCrossfade::fadeSeconds * testRateHz);

std::unique_ptr<Player> testPlayer(const std::string& folder = "test", double transpose = 1) {
    const auto state = testState(folder, transpose);
    auto instrument = buildInstrument(state.preset.keyMap, state.objects);
    REQUIRE(instrument);
    return std::make_unique<Player>(*instrument, testRateHz);
}

MidiEvent strikeNote(int note = 65) {
    return {.sampleOffset = 0, .bytes = {0x90, static_cast<std::uint8_t>(note), 110}};
}

const ParameterValues values = testState().parameters;

/// Plays a player or a crossfade. Without radiation both channels must be equal.
template <class Source>
void play(Source& source,
          std::span<float> output,
          std::span<const MidiEvent> events,
          const ParameterValues& with) {
    std::vector<float> right(output.size());
    source.process(StereoSpan{output, right}, events, with);
    REQUIRE(std::ranges::equal(output, right));
}

/// Strikes a player once and returns its sound from sample 500 on.
std::vector<float> continuation(std::size_t count) {
    auto player = testPlayer();
    std::vector<float> output(500 + count);
    const std::array events{strikeNote()};
    play(*player, output, events, values);
    return {output.begin() + 500, output.end()};
}

struct Ringing {
    Handoff<Player> handoff;
    PlayerCrossfade sound{handoff};

    Ringing() {
        sound.install(testPlayer());
        std::vector<float> output(500);
        const std::array events{strikeNote()};
        play(sound, output, events, values);
        REQUIRE(loudest(output) > 0.001f);
    }
};

} // namespace

TEST_CASE("The former sound fades out under a raised cosine of 5 ms") {
    Ringing ringing;
    const auto alone = continuation(600);
    ringing.sound.changeTo(testPlayer("other").release(), values);
    std::vector<float> output(600);
    play(ringing.sound, output, {}, values);
    for (std::size_t i = 0; i < output.size(); ++i) {
        const double place = static_cast<double>(i) / static_cast<double>(fadeSamples);
        const double gain = i < fadeSamples ? (1 + std::cos(std::numbers::pi * place)) / 2 : 0;
        REQUIRE(output[i] == static_cast<float>(gain) * alone[i]);
    }
}

TEST_CASE("A fading sound is scaled to the level of each new player") {
    Ringing plain, levelled, twice;
    plain.sound.changeTo(testPlayer("other").release(), values);
    levelled.sound.changeTo(testPlayer("other").release(), values, 0.25f);
    twice.sound.changeTo(testPlayer("other").release(), values, 0.5f);
    std::vector<float> fade(600), once(600), again(600);
    play(plain.sound, fade, {}, values);
    play(levelled.sound, once, {}, values);
    play(twice.sound, std::span(again).first(100), {}, values);
    twice.sound.changeTo(testPlayer("third").release(), values, 8.0f);
    play(twice.sound, std::span(again).subspan(100), {}, values);
    for (std::size_t i = 0; i < fade.size(); ++i) {
        REQUIRE(once[i] == fade[i] / 4);
        REQUIRE(again[i] == fade[i] * (i < 100 ? 0.5f : 4.0f));
    }
}

TEST_CASE("The fade does not depend on the block size") {
    Ringing whole, pieces;
    whole.sound.changeTo(testPlayer("other").release(), values);
    pieces.sound.changeTo(testPlayer("other").release(), values);
    std::vector<float> expected(600), output(600);
    play(whole.sound, expected, {}, values);
    for (std::size_t start = 0; start < 600; start += 7)
        play(pieces.sound, std::span(output).subspan(start, std::min<std::size_t>(7, 600 - start)),
             {}, values);
    CHECK(output == expected);
}

TEST_CASE("A fading sound keeps its parameters") {
    Ringing kept, changed;
    auto bent = values;
    bent.set(ParameterId::size, 0.5);
    kept.sound.changeTo(testPlayer("other").release(), values);
    changed.sound.changeTo(testPlayer("other").release(), values);
    std::vector<float> expected(600), output(600);
    play(kept.sound, expected, {}, values);
    play(changed.sound, output, {}, bent);
    CHECK(output == expected);
}

TEST_CASE("A new player that is struck at once sounds from its first sample without a fade-in") {
    Handoff<Player> handoff;
    PlayerCrossfade sound(handoff);
    sound.install(testPlayer());
    sound.changeTo(testPlayer("other", 1.5).release(), values);
    auto alone = testPlayer("other", 1.5);
    std::vector<float> expected(600), output(600);
    const std::array events{strikeNote()};
    play(*alone, expected, events, values);
    play(sound, output, events, values);
    CHECK(output == expected);
    CHECK(loudest(output) > 0.001f);
}

TEST_CASE("A second change during a fade does not stop the first sound's fade") {
    Ringing once, twice;
    once.sound.changeTo(testPlayer("other").release(), values);
    twice.sound.changeTo(testPlayer("other").release(), values);
    std::vector<float> expected(600), output(600);
    play(once.sound, expected, {}, values);
    play(twice.sound, std::span(output).first(100), {}, values);
    twice.sound.changeTo(testPlayer("third").release(), values);
    play(twice.sound, std::span(output).subspan(100), {}, values);
    CHECK(output == expected);
}

TEST_CASE("Pedal and pitch wheel stay in place when the player changes") {
    auto damped = values;
    damped.set(ParameterId::letRing, 0);
    const MidiEvent pedal{.sampleOffset = 0, .bytes = {0xb0, 64, 127}};
    const MidiEvent wheel{.sampleOffset = 0, .bytes = {0xe0, 0, 127}};
    const MidiEvent release{.sampleOffset = 0, .bytes = {0x80, 65, 0}};

    Handoff<Player> handoff;
    PlayerCrossfade sound(handoff);
    sound.install(testPlayer());
    std::vector<float> expected(9600), output(9600);
    const std::array before{pedal, wheel};
    play(sound, std::span(output).first(64), before, damped);
    sound.changeTo(testPlayer("other").release(), values);
    const std::array tap{strikeNote(), release};
    for (std::size_t start = 0; start < 9600; start += 960)
        play(sound, std::span(output).subspan(start, 960),
             start == 0 ? std::span<const MidiEvent>(tap) : std::span<const MidiEvent>{}, damped);

    auto alone = testPlayer("other");
    const std::array all{pedal, wheel, strikeNote(), release};
    play(*alone, expected, all, damped);
    CHECK(output == expected);
    CHECK(loudest({output.end() - 960, output.end()}) > 0.001f); // held by the pedal
}

TEST_CASE("Zones and bend ranges set by MIDI hold for every later player") {
    const auto controller = [](int channel, int number, int value) {
        return MidiEvent{.sampleOffset = 0,
                         .bytes = {static_cast<std::uint8_t>(0xb0 | channel),
                                   static_cast<std::uint8_t>(number),
                                   static_cast<std::uint8_t>(value)}};
    };
    const std::array setup{controller(0, 101, 0), controller(0, 100, 6), controller(0, 6, 5),
                           controller(1, 101, 0), controller(1, 100, 0), controller(1, 6, 24)};
    const std::array notes{MidiEvent{.sampleOffset = 0, .bytes = {0x91, 65, 110}},
                           MidiEvent{.sampleOffset = 0, .bytes = {0x92, 66, 110}},
                           MidiEvent{.sampleOffset = 0, .bytes = {0xe1, 127, 127}},
                           MidiEvent{.sampleOffset = 0, .bytes = {0xe2, 0, 0}}};
    std::vector<float> before(64), expected(4800), unbent(4800), output(4800);
    const auto alone = testPlayer("other"), plain = testPlayer("other");
    play(*alone, before, setup, values);
    alone->reset();
    play(*alone, expected, notes, values);
    play(*plain, unbent, notes, values);
    CHECK(expected != unbent);

    Handoff<Player> handoff;
    PlayerCrossfade sound(handoff);
    sound.install(testPlayer());
    play(sound, before, setup, values);
    SECTION("in the middle of the sound") {
        sound.changeTo(testPlayer("other").release(), values);
    }
    SECTION("from its start") {
        sound.install(testPlayer("other"));
    }
    play(sound, output, notes, values);
    CHECK(output == expected);
}

TEST_CASE("Speed and place of each channel stay in place when the player changes") {
    auto scraping = values;
    scraping.set(ParameterId::contact, scrapeContact);
    const MidiEvent speed{.sampleOffset = 0, .bytes = {0xb0, 1, 100}};
    const MidiEvent place{.sampleOffset = 0, .bytes = {0xb0, 74, 20}};
    const MidiEvent otherSpeed{.sampleOffset = 0, .bytes = {0xb5, 1, 3}};
    const MidiEvent otherPlace{.sampleOffset = 0, .bytes = {0xb5, 74, 120}};
    Handoff<Player> handoff;
    PlayerCrossfade sound(handoff);
    sound.install(testPlayer());
    std::vector<float> expected(4800), output(4800);
    const std::array before{speed, place, otherSpeed, otherPlace};
    play(sound, std::span(output).first(64), before, scraping);
    sound.changeTo(testPlayer("other").release(), values);
    const std::array hold{strikeNote()};
    for (std::size_t start = 0; start < 4800; start += 960)
        play(sound, std::span(output).subspan(start, 960),
             start == 0 ? std::span<const MidiEvent>(hold) : std::span<const MidiEvent>{},
             scraping);

    auto alone = testPlayer("other");
    const std::array all{speed, place, otherSpeed, otherPlace, strikeNote()};
    play(*alone, expected, all, scraping);
    CHECK(output == expected);
    CHECK(loudest(output) > 0);
}

TEST_CASE("A reset is silent at once, also in a fade") {
    Ringing ringing;
    ringing.sound.changeTo(testPlayer("other").release(), values);
    ringing.sound.reset();
    std::vector<float> output(600, 1.0f);
    play(ringing.sound, output, {}, values);
    CHECK(loudest(output) == 0);
}

TEST_CASE("Without a player the output is silent") {
    Handoff<Player> handoff;
    PlayerCrossfade sound(handoff);
    std::vector<float> output(100, 1.0f);
    const std::array events{strikeNote()};
    play(sound, output, events, values);
    sound.reset();
    CHECK(loudest(output) == 0);
}
