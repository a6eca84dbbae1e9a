#include "Instrument/Player.h"
#include "Instrument/MalletStrike.h"
#include "Instrument/SettingsOfParameters.h"
#include "Support/PoleFit.h"
#include "Support/RenderNotes.h"
#include "Support/SyntheticObject.h"

#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>
#include <set>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;

/// Keys 60 to 72, a bar of two modes each, which radiate to the left and right in parts of their
/// own.
std::shared_ptr<const Instrument> bars() {
    ObjectLibrary library;
    std::vector<std::shared_ptr<const ModalObject>> kept;
    for (int note = 60; note <= 72; ++note) {
        const double frequencyHz = 440 * std::exp2((note - 69) / 12.0);
        auto bar = syntheticObject({frequencyHz, 3 * frequencyHz});
        bar.radiation = {.directions = {{-0.6f, 0, 0.8f}, {0.6f, 0, 0.8f}},
                         .frequencyRatios = {1},
                         .weights = {0.02f, -0.01f, 0.03f, 0.02f}};
        kept.push_back(library.add("bar-" + std::to_string(note), std::move(bar)));
    }
    KeyMap map;
    map.kind = KeyMapKind::bars;
    map.lowestNote = 60;
    map.highestNote = 72;
    map.object = "bar-{note}";
    return Instrument::build(map, library).value();
}

double level(std::span<const float> signal) {
    double sum = 0;
    for (const float sample : signal)
        sum += sample * sample;
    return std::sqrt(sum / static_cast<double>(signal.size()));
}

std::complex<double> phasorAt(std::span<const float> signal, double frequencyHz) {
    std::complex<double> sum = 0;
    for (std::size_t k = 0; k < signal.size(); ++k) {
        const double turn = 2 * std::numbers::pi * static_cast<double>(k);
        sum += (1 - std::cos(turn / static_cast<double>(signal.size()))) *
               static_cast<double>(signal[k]) * std::polar(1.0, -turn * frequencyHz / sampleRateHz);
    }
    return sum;
}

std::vector<MidiEvent> busyEvents(int samples) {
    std::mt19937 random(3);
    std::vector<MidiEvent> events;
    for (int time = 5; time < samples; time += static_cast<int>(random() % 700)) {
        const int note = 58 + static_cast<int>(random() % 17);
        switch (random() % 8) {
        case 0:
            events.push_back(midi(time, 0xb0, 64, random() % 2 ? 127 : 0));
            break;
        case 1:
            events.push_back(midi(time, 0xe0, 0, static_cast<int>(random() % 128)));
            break;
        case 2:
            events.push_back(midi(time, 0x80, note, 0));
            break;
        default:
            events.push_back(midi(time, 0x90, note, 1 + static_cast<int>(random() % 127)));
        }
    }
    return events;
}

} // namespace

TEST_CASE("Renders are bit-identical for block sizes 1, 7, 64, 480 and 4096") {
    const auto instrument = bars();
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    const auto events = busyEvents(30000);
    Player reference(instrument, sampleRateHz);
    const auto expected = render(reference, events, 30000, 512, parameters);
    CHECK(peak(expected) > 0.001f);
    const auto blockSize = GENERATE(1u, 7u, 64u, 480u, 4096u);
    Player player(instrument, sampleRateHz);
    CHECK(render(player, events, 30000, blockSize, parameters) == expected);
}

TEST_CASE("Stereo renders are bit-identical for block sizes 1, 7, 64, 480 and 4096") {
    const auto instrument = bars();
    ParameterValues parameters;
    parameters.set(ParameterId::radiation, 60);
    parameters.set(ParameterId::letRing, 0);
    const auto events = busyEvents(20000);
    Player reference(instrument, sampleRateHz);
    const auto expected = renderStereo(reference, events, 20000, 512, parameters);
    CHECK(peak(expected.left) > 0.001f);
    CHECK(expected.left != expected.right);
    const auto blockSize = GENERATE(1u, 7u, 64u, 480u, 4096u);
    Player player(instrument, sampleRateHz);
    CHECK(renderStereo(player, events, 20000, blockSize, parameters) == expected);
    player.reset();
    CHECK(renderStereo(player, events, 20000, blockSize, parameters) == expected);
}

TEST_CASE("Without radiation both channels are the sound at the point struck") {
    const auto instrument = bars();
    Player player(instrument, sampleRateHz);
    const auto sound = renderStereo(player, busyEvents(20000), 20000, 512);
    CHECK(sound.left == sound.right);

    // Key 69's own slot, struck without a player.
    ParameterValues parameters;
    parameters.set(ParameterId::strikeSpread, 0);
    Player one(instrument, sampleRateHz);
    const auto played = renderStereo(one, {midi(0, 0x90, 69, 100)}, 2048, 512, parameters);
    const auto& key = instrument->key(69);
    Synthesiser mono({instrument->slots()[static_cast<std::size_t>(key.slot)]}, sampleRateHz);
    mono.setSettings(synthesisSettings(parameters));
    const auto strike =
        malletStrike(instrument->strip(key).between(key.along, 0).point, 100, 1, parameters,
                     surfaceCompliancePerPa(instrument->slots()[0].object->material, parameters));
    std::vector<float> expected(2048);
    for (std::size_t at = 0; at < expected.size(); at += cellSamples) {
        alignas(64) std::array<float, cellSamples> cell{};
        mono.beginCell(cell);
        if (at == 0)
            REQUIRE(mono.strike(0, strike, 0, cell));
        std::ranges::copy(cell, expected.begin() + static_cast<std::ptrdiff_t>(at));
    }
    CHECK(played.left == expected);
    CHECK(played.right == expected);
}

TEST_CASE("After a reset the same events sound the same to the last bit") {
    Player player(bars(), sampleRateHz);
    const auto events = busyEvents(10000);
    const auto first = render(player, events, 10000, 100);
    player.reset();
    CHECK(player.silent());
    CHECK(render(player, events, 10000, 100) == first);
}

TEST_CASE("With radiation left and right are apart, at the same pitch") {
    for (const double percent : {0.0, 30.0, 60.0, 100.0}) {
        ParameterValues parameters;
        parameters.set(ParameterId::radiation, percent);
        Player player(bars(), sampleRateHz);
        const auto sound = renderStereo(player, {midi(0, 0x90, 69, 100)}, 24000, 480, parameters);
        std::vector<float> side(sound.left.size());
        for (std::size_t i = 0; i < side.size(); ++i)
            side[i] = sound.left[i] - sound.right[i];
        const double apart = level(side) / (level(sound.left) + level(sound.right));
        CHECK((percent == 0 ? apart == 0 : apart > 0.01));
        for (const auto* channel : {&sound.left, &sound.right})
            CHECK(std::abs(cents(fitPole(*channel, sampleRateHz, 440, 0.05).frequencyHz, 440)) <
                  0.1);
    }
}

TEST_CASE("A note starts at its very sample") {
    const int start = GENERATE(0, 1, 63, 64, 65, 1000);
    Player player(bars(), sampleRateHz);
    const auto sound = render(player, {midi(start, 0x90, 69, 127)}, 2000, 333);
    CHECK(peak(std::span(sound).first(static_cast<std::size_t>(start))) == 0);
    CHECK(peak(std::span(sound).subspan(static_cast<std::size_t>(start), 8)) > 0);
}

TEST_CASE("With let-ring off a released key falls by 60 dB in the release time, else it rings on") {
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
        return 20 * std::log10(level(std::span(released).subspan(sample, 480)) /
                               level(std::span(ringing).subspan(sample, 480)));
    };
    CHECK(std::equal(released.begin(), released.begin() + atRelease, ringing.begin()));
    CHECK(ratioAt(atRelease + 4800 - 240) == Approx(-30).margin(0.2));
    CHECK(ratioAt(atRelease + 9600 - 240) == Approx(-60).margin(0.2));

    parameters.set(ParameterId::letRing, 1);
    Player letRing(bars(), sampleRateHz);
    CHECK(render(letRing, events, 24000, 256, parameters) == ringing);
}

TEST_CASE("The sustain pedal holds released keys until it is lifted") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.05);
    const std::vector events{midi(0, 0xb0, 64, 127), midi(10, 0x90, 69, 100),
                             midi(500, 0x80, 69, 0), midi(9600, 0xb0, 64, 0)};
    Player player(bars(), sampleRateHz);
    const auto sound = render(player, events, 19200, 256, parameters);
    const auto at = [&](std::size_t sample) {
        return level(std::span(sound).subspan(sample, 480));
    };
    CHECK(at(9000) > 0.3 * at(1000));
    CHECK(at(12500) < 0.001 * at(9000));
}

TEST_CASE("A key struck again just after its release is not damped") {
    ParameterValues parameters;
    parameters.set(ParameterId::letRing, 0);
    parameters.set(ParameterId::releaseTime, 0.02);
    Player player(bars(), sampleRateHz);
    const std::vector events{midi(0, 0x90, 69, 100), midi(4805, 0x80, 69, 0),
                             midi(4810, 0x90, 69, 100)};
    const auto sound = render(player, events, 14400, 256, parameters);
    CHECK(level(std::span(sound).subspan(13000, 960)) >
          0.3 * level(std::span(sound).subspan(5200, 960)));
}

TEST_CASE("The pitch wheel bends by its range, and reset controllers brings the pitch back") {
    Player player(bars(), sampleRateHz);
    const std::vector events{midi(0, 0x90, 69, 100), midi(0, 0xe0, 127, 127),
                             midi(24000, 0xb0, 121, 0)};
    const auto sound = render(player, events, 48000, 256);
    const auto bent =
        fitPole(std::span(sound).first(24000), sampleRateHz, 440 * std::exp2(2 / 12.0), 0.05);
    CHECK(std::abs(cents(bent.frequencyHz, 440) - 200) < 0.5);
    const auto back = fitPole(std::span(sound).subspan(24064), sampleRateHz, 440, 0.05);
    CHECK(std::abs(cents(back.frequencyHz, 440)) < 0.5);
}

TEST_CASE("All sound off silences within 50 ms, and the next note sounds again") {
    Player player(bars(), sampleRateHz);
    const auto sound = render(player,
                              {midi(0, 0x90, 69, 127), midi(0, 0x90, 60, 127),
                               midi(4800, 0xb0, 120, 0), midi(9600, 0x90, 69, 127)},
                              14400, 256);
    CHECK(peak(std::span(sound).subspan(7200, 2400)) < 1e-4f * peak(sound));
    CHECK(peak(std::span(sound).subspan(9600)) > 0.5f * peak(sound));
}

TEST_CASE("Notes outside the keys, and messages that mean nothing here, are silent") {
    Player player(bars(), sampleRateHz);
    const auto sound = render(player,
                              {midi(0, 0x90, 20, 127), midi(1, 0xa0, 69, 127), midi(2, 0xd0, 99, 0),
                               midi(3, 0x90, 69, 0), midi(4, 0xf8, 0, 0)},
                              1000, 256);
    CHECK(peak(sound) == 0);
    CHECK_FALSE(player.takeProgramChange());
}

TEST_CASE("A program change is reported once") {
    Player player(bars(), sampleRateHz);
    render(player, {midi(0, 0xc0, 5, 0)}, 100, 50);
    CHECK(player.takeProgramChange() == 5);
    CHECK_FALSE(player.takeProgramChange());
}

TEST_CASE("A library material moves every frequency by the square root of Y over density") {
    ParameterValues parameters;
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

TEST_CASE("Silence returns when all notes have died away") {
    Player player(bars(), sampleRateHz);
    CHECK(player.silent());
    render(player, {midi(0, 0x90, 69, 100)}, 64, 64);
    CHECK_FALSE(player.silent());
    const auto tail = render(player, {}, 48000 * 12, 4096);
    CHECK(player.silent());
    CHECK(peak(std::span(tail).last(4800)) == 0);
}

TEST_CASE("Matching loudness multiplies by the gain that is predicted, at once from the start") {
    const auto instrument = bars();
    ParameterValues own;
    own.set(ParameterId::strikeSpread, 0);
    ParameterValues hard = own;
    hard.set(ParameterId::malletMass, 80);
    LoudnessMatch match(instrument, {}, sampleRateHz, own);
    hard.set(ParameterId::matchLoudness, 1);
    match.prepare(hard);
    hard.set(ParameterId::matchLoudness, 0);
    const double gain = std::pow(10, match.gainDb() / 20);
    CHECK(gain < 0.7);
    const std::vector events{midi(10, 0x90, 64, 100), midi(700, 0x90, 69, 100)};
    Player plain(instrument, sampleRateHz, {}, 1, own);
    Player matching(instrument, sampleRateHz, {}, 1, own);
    const auto before = render(plain, events, 9600, 333, hard);
    hard.set(ParameterId::matchLoudness, 1);
    const auto after = render(matching, events, 9600, 480, hard);
    for (std::size_t i = 0; i < before.size(); ++i)
        REQUIRE(double(after[i]) == Approx(gain * double(before[i])).margin(1e-7).epsilon(1e-4));
}

TEST_CASE("A mallet that changes while loudness is matched moves the gain without a step") {
    const auto instrument = bars();
    ParameterValues own;
    own.set(ParameterId::matchLoudness, 1);
    own.set(ParameterId::strikeSpread, 0);
    ParameterValues heavy = own;
    heavy.set(ParameterId::malletMass, 200);
    const auto ringing = [&](int blockSize) {
        Player player(instrument, sampleRateHz, {}, 1, own);
        auto sound = render(player, {midi(0, 0x90, 64, 100)}, 9600, blockSize, own);
        const auto later = render(player, {}, 9600, blockSize, heavy);
        sound.insert(sound.end(), later.begin(), later.end());
        return sound;
    };
    const auto sound = ringing(480);
    CHECK(sound == ringing(64));
    Player still(instrument, sampleRateHz, {}, 1, own);
    const auto unchanged = render(still, {midi(0, 0x90, 64, 100)}, 19200, 480, own);
    double last = 1, steepest = 0;
    for (std::size_t i = 9000; i < sound.size(); ++i) {
        if (std::abs(unchanged[i]) < 0.02f * peak(unchanged))
            continue;
        const double ratio = double(sound[i]) / double(unchanged[i]);
        steepest = std::max(steepest, std::abs(ratio - last));
        last = ratio;
    }
    CHECK(last < 0.5);
    CHECK(steepest < 0.02);
}

TEST_CASE("Every key of the plate is struck in a place of its own") {
    const auto plate = Instrument::build({.kind = KeyMapKind::zones,
                                          .lowestNote = 36,
                                          .highestNote = 96,
                                          .object = "plate",
                                          .strikePath = {{-1, -1, 0}, {0.3, 0.8, 0}}},
                                         ObjectLibrary::shared())
                           .value();
    ParameterValues parameters;
    parameters.set(ParameterId::strikeSpread, 0);
    std::set<std::vector<float>> sounds;
    for (int note = 36; note <= 96; ++note) {
        Player player(plate, sampleRateHz);
        sounds.insert(render(player, {midi(0, 0x90, note, 100)}, 2400, 480, parameters));
    }
    CHECK(sounds.size() == 61);
}

TEST_CASE("A note handed over with an empty block, or beyond a block's end, starts the next one") {
    const auto instrument = bars();
    Player expected(instrument, sampleRateHz);
    auto sound = render(expected, {}, 100, 100);
    const auto after = render(expected, {midi(0, 0x90, 69, 100)}, 4800, 480);
    CHECK(peak(after) > 0.001f);

    Player empty(instrument, sampleRateHz);
    render(empty, {}, 100, 100);
    const std::array note{midi(0, 0x90, 69, 100)};
    empty.process(StereoSound(0), note, {});
    CHECK_FALSE(empty.silent());
    CHECK(render(empty, {}, 4800, 480) == after);

    Player beyond(instrument, sampleRateHz);
    StereoSound block(100);
    const std::array lateNote{midi(100, 0x90, 69, 100)};
    beyond.process(block, lateNote, {});
    CHECK(peak(block.left) == 0);
    CHECK(render(beyond, {}, 4800, 480) == after);

    Player silenced(instrument, sampleRateHz);
    const std::array both{midi(0, 0x90, 69, 100), midi(0, 0xb0, 120, 0)};
    silenced.process(StereoSound(0), both, {});
    CHECK(silenced.silent());
}

TEST_CASE("However many blows come at once, none is lost: together they are as loud as their sum") {
    ObjectLibrary library;
    const auto kept = library.add("bar", syntheticObject({200, 540, 1070, 1800, 2500}));
    KeyMap map;
    map.kind = KeyMapKind::zones;
    map.lowestNote = 20;
    map.highestNote = 110;
    map.object = "bar";
    const auto instrument = Instrument::build(map, library).value();
    ParameterValues parameters;
    parameters.set(ParameterId::strikeSpread, 0);
    parameters.set(ParameterId::modalPulse, GENERATE(0, 1));
    const auto struck = [&](int keys) {
        std::vector<MidiEvent> events;
        for (int i = 0; i < keys; ++i)
            events.push_back(midi(0, 0x90, 20 + i, 100));
        Player player(instrument, sampleRateHz);
        auto sound = render(player, events, 28800, 64, parameters);
        sound.erase(sound.begin(), sound.begin() + 2400);
        return sound;
    };
    const auto one = struck(1);
    for (const int keys : {16, 60, 90}) {
        const auto all = struck(keys);
        INFO(keys << " keys: " << level(all) / level(one) / keys);
        CHECK(level(all) > 0.95 * keys * level(one));
        CHECK(level(all) < 1.25 * keys * level(one));
        // Where most of the impulse goes nothing changes: the phase is that of the pulses.
        CHECK(std::abs(phasorAt(all, 200) / phasorAt(one, 200) - double(keys)) < 0.02 * keys);
    }
}

TEST_CASE("Crowded blows are bit-identical for block sizes 1, 64, 333 and 4096") {
    ObjectLibrary library;
    const auto kept = library.add("bar", syntheticObject({60, 200, 540, 1070, 1800}));
    KeyMap map;
    map.kind = KeyMapKind::zones;
    map.lowestNote = 20;
    map.highestNote = 110;
    map.object = "bar";
    const auto instrument = Instrument::build(map, library).value();
    ParameterValues parameters;
    parameters.set(ParameterId::modalPulse, 1);
    parameters.set(ParameterId::chatter, 100);
    std::vector<MidiEvent> events;
    for (int i = 0; i < 300; ++i)
        events.push_back(midi(3 + 7 * i / 3, 0x90, 20 + i * 37 % 91, 1 + i % 127));
    Player reference(instrument, sampleRateHz);
    const auto expected = render(reference, events, 9600, 512, parameters);
    CHECK(peak(expected) > 0.001f);
    for (const std::size_t blockSize : {1, 64, 333, 4096}) {
        Player player(instrument, sampleRateHz);
        CHECK(render(player, events, 9600, blockSize, parameters) == expected);
    }
}

TEST_CASE("The seed is in the spread and the chatter of strikes, and nothing else of them") {
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
