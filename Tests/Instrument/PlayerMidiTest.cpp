// Tests a player's response to MIDI messages: releases, pedals, wheel and others.
#include "Instrument/Player.h"
#include "Support/Highs.h"
#include "Support/Level.h"
#include "Support/PoleFit.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <algorithm>
#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <string_view>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;

} // namespace

TEST_CASE(
    "With let-ring off a released key falls by 60 dB in the release time; otherwise it rings") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.2);
    parameters.set(ParameterId::strikeSpread, 0);
    const std::vector events{midi(0, 0x90, 69, 100), midi(4801, 0x80, 69, 0)};
    const std::size_t atRelease = 4864; // the first grid point at or after the stamp
    Player damped(bars(), sampleRateHz);
    Player held(bars(), sampleRateHz);
    const auto released = render(damped, events, 24000, 256, parameters);
    const auto ringing = render(held, {events[0]}, 24000, 256, parameters);
    const auto ratioAt = [&](std::size_t sample) {
        return 20 * std::log10(rms(std::span(released).subspan(sample, 480)) /
                               rms(std::span(ringing).subspan(sample, 480)));
    };
    CHECK(std::equal(released.begin(), released.begin() + atRelease, ringing.begin()));
    CHECK(ratioAt(atRelease + 4800 - 240) == Approx(-30).margin(0.2));
    CHECK(ratioAt(atRelease + 9600 - 240) == Approx(-60).margin(0.2));

    parameters.set(ParameterId::letRing, 1);
    Player letRing(bars(), sampleRateHz);
    CHECK(render(letRing, events, 24000, 256, parameters) == ringing);
}

TEST_CASE("The sustain pedal holds released keys until it goes up") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.05);
    const std::vector events{midi(0, 0xb0, 64, 127), midi(10, 0x90, 69, 100),
                             midi(500, 0x80, 69, 0), midi(9600, 0xb0, 64, 0)};
    Player player(bars(), sampleRateHz);
    const auto sound = render(player, events, 19200, 256, parameters);
    const auto at = [&](std::size_t sample) { return rms(std::span(sound).subspan(sample, 480)); };
    CHECK(at(9000) > 0.3 * at(1000));
    CHECK(at(12500) < 0.001 * at(9000));
}

TEST_CASE("The sostenuto pedal holds only the keys that were down before it") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.05);
    const auto levels = [&](int note, int noteAt) {
        const std::vector events{midi(noteAt, 0x90, note, 100), midi(noteAt + 100, 0x80, note, 0)};
        std::vector all{midi(500, 0xb0, 66, 127), midi(600, 0xb0, 66, 100),
                        midi(9600, 0xb0, 66, 0)};
        all.insert(all.end(), events.begin(), events.end());
        std::ranges::stable_sort(all, {}, &MidiEvent::sampleOffset);
        Player player(bars(), sampleRateHz);
        const auto sound = render(player, all, 19200, 256, parameters);
        const auto at = [&](std::size_t sample) {
            return rms(std::span(sound).subspan(sample, 480));
        };
        return std::array{at(1000), at(9000), at(12500)};
    };
    const auto caught = levels(69, 450); // still down when the pedal goes down at 500
    CHECK(caught[1] > 0.3 * caught[0]);
    CHECK(caught[2] < 0.001 * caught[1]);
    const auto later = levels(69, 700);
    CHECK(later[1] < 0.001 * later[0]);
}

TEST_CASE("A released key rings while either pedal holds it, in any order") {
    // K, S, O, F: the key, sustain, sostenuto and soft pedal go down; lower case: up.
    struct Sequence {
        std::string_view moves;
        bool rings;
    };
    const auto [moves, rings] = GENERATE(values<Sequence>({
        {"Kk", false},      {"KOkSo", true},     {"KOkSos", false},  {"KOkSs", true},
        {"KOkSso", false},  {"KOSko", true},     {"KOSkos", false},  {"KOSks", true},
        {"KOSkso", false},  {"KOSok", true},     {"KOSosk", false},  {"KOSos", true},
        {"KOSosSk", true},  {"KOkoS", false},    {"KSOkos", false},  {"KSOko", true},
        {"KSOks", true},    {"KSOkso", false},   {"KSkOs", false},   {"KSkO", true},
        {"KSkOo", true},    {"OKk", false},      {"OKSko", true},    {"OSKkos", false},
        {"OSKks", false},   {"SOKko", true},     {"KFOkSo", true},   {"KOFkSfo", true},
        {"KOkSoFs", false}, {"KOSFkfso", false}, {"FKOkSoKk", true}, {"KOkSoKsk", false},
        {"KOkSOo", true},   {"KOkSoOs", false},
    }));
    CAPTURE(moves);
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.05);
    parameters.set(ParameterId::strikeSpread, 0);
    std::vector<MidiEvent> events;
    int sample = 0;
    for (const char move : moves) {
        const int value = move < 'a' ? 100 : 0;
        switch (move) {
        case 'K':
        case 'k':
            events.push_back(midi(sample, 0x90, 69, value));
            break;
        case 'S':
        case 's':
            events.push_back(midi(sample, 0xb0, 64, value));
            break;
        case 'O':
        case 'o':
            events.push_back(midi(sample, 0xb0, 66, value));
            break;
        default:
            events.push_back(midi(sample, 0xb0, 67, value));
        }
        sample += 100;
    }
    Player player(bars(), sampleRateHz), undamped(bars(), sampleRateHz);
    const auto sound = render(player, events, 9600, 256, parameters);
    parameters.set(ParameterId::letRing, 1);
    const auto ringing = render(undamped, events, 9600, 256, parameters);
    const double share = rms(std::span(sound).last(960)) / rms(std::span(ringing).last(960));
    CHECK(share < (rings ? 1.1 : 0.01));
    CHECK(share >= (rings ? 0.3 : 0));
}

TEST_CASE("The soft pedal makes strikes softer and darker in proportion to its position") {
    const auto played = [](int pedal) {
        Player player(bars(), sampleRateHz);
        return render(player, {midi(0, 0xb0, 67, pedal), midi(1, 0x90, 69, 100)}, 9600, 256);
    };
    const auto hard = played(0), half = played(64), soft = played(127);
    const double softer = 20 * std::log10(rms(soft) / rms(hard));
    CHECK(softer == Approx(-6).margin(1));
    CHECK(rms(half) < rms(hard));
    CHECK(rms(half) > rms(soft));
    CHECK(loudestHighsDb(soft, sampleRateHz) - loudestHighsDb(hard, sampleRateHz) < softer - 0.5);
    Player player(bars(), sampleRateHz);
    const auto reset = render(
        player, {midi(0, 0xb0, 67, 127), midi(0, 0xb0, 121, 0), midi(1, 0x90, 69, 100)}, 9600, 256);
    CHECK(reset == hard);
}

TEST_CASE("A key struck again just after its release is not damped") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.02);
    Player player(bars(), sampleRateHz);
    const std::vector events{midi(0, 0x90, 69, 100), midi(4805, 0x80, 69, 0),
                             midi(4810, 0x90, 69, 100)};
    const auto sound = render(player, events, 14400, 256, parameters);
    CHECK(rms(std::span(sound).subspan(13000, 960)) >
          0.3 * rms(std::span(sound).subspan(5200, 960)));
}

TEST_CASE("The pitch wheel bends by its range, and Reset All Controllers restores the pitch") {
    Player player(bars(), sampleRateHz);
    const std::vector events{midi(0, 0x90, 69, 100), midi(0, 0xe0, 127, 127),
                             midi(24000, 0xb0, 121, 0)};
    const auto sound = render(player, events, 48000, 256);
    const auto bent =
        fitPole(std::span(sound).first(24000), sampleRateHz, 440 * std::exp2(2 / 12.0), 0.05);
    CHECK(std::abs(cents(bent.frequencyHz, 440) - 200) < 0.5);
    const auto back = fitPole(std::span(sound).subspan(26400), sampleRateHz, 440, 0.05);
    CHECK(std::abs(cents(back.frequencyHz, 440)) < 0.5);
}

TEST_CASE("Notes outside the keys and unknown messages are silent") {
    Player player(bars(), sampleRateHz);
    const auto sound = render(player,
                              {midi(0, 0x90, 20, 127), midi(1, 0xa0, 69, 127), midi(2, 0xd0, 99, 0),
                               midi(3, 0x90, 69, 0), midi(4, 0xf8, 0, 0), midi(5, 0xc0, 5, 0)},
                              1000, 256);
    CHECK(peak(sound) == 0);
}

TEST_CASE("All Notes Off and every channel mode message release the keys") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.05);
    const auto after = [&](int number) {
        Player player(bars(), sampleRateHz);
        const auto sound = render(player, {midi(0, 0x90, 69, 100), midi(4800, 0xb0, number, 0)},
                                  14400, 256, parameters);
        return rms(std::span(sound).subspan(9600, 4800)) / rms(std::span(sound).first(4800));
    };
    CHECK(after(122) > 0.3); // local control: does not concern a player
    for (const int number : {123, 124, 125, 126, 127}) {
        INFO("controller " << number);
        CHECK(after(number) < 0.001);
    }
}

TEST_CASE("A strike anywhere in a cell is equally loud, at its own pitch and with its damper up") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.05);
    parameters.set(ParameterId::strikeSpread, 0);
    parameters.set(ParameterId::bendRange, 24);
    const bool isBent = GENERATE(false, true), isStruckAgain = GENERATE(false, true);
    CAPTURE(isBent, isStruckAgain);
    const auto levelAt = [&](int offset) {
        std::vector<MidiEvent> events;
        if (isBent)
            events.push_back(midi(0, 0xe0, 127, 127));
        if (isStruckAgain) {
            events.push_back(midi(0, 0x90, 69, 100));
            events.push_back(midi(4800, 0x80, 69, 0));
        }
        if (isBent)
            events.push_back(midi(6400 + offset, 0xe0, 0, 64));
        events.push_back(midi(6400 + offset, 0x90, 69, 100));
        Player player(bars(), sampleRateHz);
        const auto sound = render(player, events, 19200, 256, parameters);
        return 20 * std::log10(rms(std::span(sound).subspan(9600, 4800)));
    };
    const double atStart = levelAt(0);
    for (const int offset : {1, 17, 40, 63}) {
        CAPTURE(offset);
        CHECK(std::abs(levelAt(offset) - atStart) < 0.2);
    }
}

TEST_CASE("A note of an empty block sounds as it does in the next block") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.005);
    parameters.set(ParameterId::strikeSpread, 0);
    constexpr int offset = 17;
    const auto played = [&](bool ahead) {
        Player player(bars(), sampleRateHz);
        auto sound = render(player, {midi(0, 0x90, 69, 100), midi(3200, 0x80, 69, 0)},
                            6400 + offset, 256, parameters);
        const std::vector again{midi(0, 0x90, 69, 100)};
        if (ahead)
            player.process(StereoSpan{}, again, parameters);
        const auto rest =
            render(player, ahead ? std::vector<MidiEvent>() : again, 9600, 256, parameters);
        sound.insert(sound.end(), rest.begin(), rest.end());
        return sound;
    };
    const auto expected = played(false);
    REQUIRE(rms(std::span(expected).subspan(6400, 4800)) > 1e-4);
    CHECK(played(true) == expected);
}

TEST_CASE("Pressure at a key's sample belongs to that key in either order") {
    ParameterValues parameters;
    parameters.set(ParameterId::contact, scrapeContact);
    const auto pressure = midi(100, 0xd0, 127, 0), key = midi(100, 0x90, 69, 20);
    Player first(bars(), sampleRateHz), last(bars(), sampleRateHz), none(bars(), sampleRateHz);
    const auto before = render(first, {pressure, key}, 9600, 256, parameters);
    CHECK(before == render(last, {key, pressure}, 9600, 256, parameters));
    CHECK(rms(before) > 1.5 * rms(render(none, {key}, 9600, 256, parameters)));
}

TEST_CASE("Pressure 0 after a key replaces its velocity, but pressure 0 before the key does not") {
    ParameterValues parameters;
    parameters.set(ParameterId::contact, scrapeContact);
    const auto pressure = midi(100, 0xd0, 0, 0), key = midi(100, 0x90, 69, 100);
    const auto played = [&](const std::vector<MidiEvent>& events) {
        Player player(bars(), sampleRateHz);
        return render(player, events, 9600, 256, parameters);
    };
    const auto expected = played({key});
    REQUIRE(rms(expected) > 0);
    CHECK(played({pressure, key}) == expected);
    CHECK(played({midi(99, 0xd0, 0, 0), key}) == expected);
    CHECK(rms(played({key, pressure})) < 1e-3 * rms(expected));
    CHECK(played({midi(100, 0xd0, 30, 0), pressure, key}) == expected);
    CHECK(played({midi(100, 0xa0, 69, 30), pressure, key}) == expected);
}

TEST_CASE("A new key does not change the last pressure of other keys at its sample") {
    ParameterValues parameters;
    parameters.set(ParameterId::contact, scrapeContact);
    const auto held = midi(50, 0x90, 69, 100), other = midi(100, 0x90, 71, 100);
    const auto played = [&](std::vector<MidiEvent> events) {
        events.insert(events.begin(), held);
        Player player(bars(), sampleRateHz);
        return render(player, events, 9600, 256, parameters);
    };
    const auto pressed = midi(100, 0xa0, 69, 30), released = midi(100, 0xa0, 69, 0);
    const auto pressedAll = midi(100, 0xd0, 30, 0), releasedAll = midi(100, 0xd0, 0, 0);
    const auto expected = played({other, released});
    CHECK(expected != played({other, pressed}));
    CHECK(played({pressed, released, other}) == expected);
    CHECK(played({pressedAll, releasedAll, other}) == expected);
    CHECK(played({pressed, releasedAll, other}) == expected);
    CHECK(played({pressed, other, released}) == expected);
}
