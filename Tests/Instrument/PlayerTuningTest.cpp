// Tests the pitches of keys: tunings, bends of single notes, and pressure on struck keys.
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "Instrument/ScalaTuning.h"
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
#include <numbers>
#include <span>

using namespace idiophone;
using namespace idiophone::test;
using Catch::Approx;

namespace {

constexpr double sampleRateHz = 48000;

KeyTuning tuningWith(int note, double semitones) {
    KeyTuning tuning;
    tuning.semitonesFromEqual[static_cast<std::size_t>(note)] = semitones;
    return tuning;
}

double soundingHz(std::span<const float> sound, double expectedHz) {
    return fitPole(sound, sampleRateHz, expectedHz, 0.05).frequencyHz;
}

ParameterValues withMpe() {
    ParameterValues values;
    values.set(ParameterId::mpe, 1);
    return values;
}

} // namespace

TEST_CASE("Concert pitch moves every key") {
    ParameterValues values;
    values.set(ParameterId::concertPitch, 432);
    Player player(bars(), sampleRateHz);
    const auto sound = render(player, {midi(0, 0x90, 69, 100)}, 24000, 256, values);
    CHECK(std::abs(cents(soundingHz(sound, 432), 432)) < 0.5);
}

TEST_CASE("Bars sound at the pitch that the tuning gives their key") {
    Player player(bars(), sampleRateHz);
    player.setTuning(tuningWith(69, -0.31));
    const auto sound = render(player, {midi(0, 0x90, 69, 100)}, 24000, 256);
    CHECK(std::abs(cents(soundingHz(sound, 430), 440) + 31) < 0.5);
    Player other(bars(), sampleRateHz);
    other.setTuning(tuningWith(69, -0.31));
    Player untuned(bars(), sampleRateHz);
    CHECK(render(other, {midi(0, 0x90, 64, 100)}, 4800, 256) ==
          render(untuned, {midi(0, 0x90, 64, 100)}, 4800, 256));
}

TEST_CASE("A change of tuning moves ringing sound without a step") {
    Player player(bars(), sampleRateHz);
    auto sound = render(player, {midi(0, 0x90, 69, 100)}, 24000, 256);
    player.setTuning(tuningWith(69, 0.5));
    const auto later = render(player, {}, 24000, 256);
    CHECK(std::abs(cents(soundingHz(later, 453), 440) - 50) < 0.5);
    sound.insert(sound.end(), later.begin(), later.end());
    const auto steepest = [](std::span<const float> part) {
        float most = 0;
        for (std::size_t i = 1; i < part.size(); ++i)
            most = std::max(most, std::abs(part[i] - part[i - 1]));
        return most;
    };
    CHECK(steepest(std::span(sound).subspan(23990, 100)) <
          1.1f * steepest(std::span(sound).subspan(20000, 3000)));
}

TEST_CASE("A key without a pitch is silent, also under the pedal") {
    KeyTuning tuning;
    tuning.unmapped.set(69);
    Player player(bars(), sampleRateHz);
    player.setTuning(tuning);
    CHECK(peak(render(player,
                      {midi(0, 0xb0, 64, 127), midi(0, 0x90, 69, 127), midi(900, 0x80, 69, 0)},
                      4800, 256)) == 0);
    CHECK(peak(render(player, {midi(0, 0x90, 70, 127)}, 4800, 256)) > 0);
}

TEST_CASE("Ringing sound keeps its pitch when its key loses it") {
    Player player(bars(), sampleRateHz);
    player.setTuning(tuningWith(69, -0.31));
    render(player, {midi(0, 0x90, 69, 100)}, 4800, 256);
    KeyTuning without;
    without.unmapped.set(69);
    player.setTuning(without);
    CHECK(std::abs(cents(soundingHz(render(player, {}, 24000, 256), 430), 440) + 31) < 0.5);
}

TEST_CASE("Keys that share an object keep its pitch in any tuning") {
    KeyTuning tuning;
    tuning.semitonesFromEqual.fill(0.7);
    tuning.unmapped.set(60);
    Player tuned(plate(), sampleRateHz), untuned(plate(), sampleRateHz);
    tuned.setTuning(tuning);
    CHECK(render(tuned, {midi(0, 0x90, 60, 100)}, 4800, 256) ==
          render(untuned, {midi(0, 0x90, 60, 100)}, 4800, 256));
}

TEST_CASE("With MPE two notes bend separately, and each keeps its bend after its release") {
    const auto off = midi(24000, 0x81, 69, 0), wheel = midi(24000, 0xe1, 0, 64),
               on = midi(24000, 0x91, 60, 1);
    // JUCE's VST3 wrapper puts wheels before the notes of their sample.
    const auto order = GENERATE_COPY(std::array{off, wheel, on}, std::array{wheel, off, on},
                                     std::array{wheel, on, off});
    std::vector events{midi(0, 0x91, 69, 100), midi(0, 0xe1, 0, 66)};
    events.insert(events.end(), order.begin(), order.end());
    Player player(bars(), sampleRateHz);
    const auto sound = render(player, events, 48000, 256, withMpe());
    const double bent = 48.0 * (66 * 128 - 8192) / 8191 * 100;
    const double bentHz = 440 * std::exp2(bent / 1200);
    CHECK(std::abs(cents(soundingHz(std::span(sound).subspan(64, 23900), bentHz), bentHz)) < 0.5);
    CHECK(std::abs(cents(soundingHz(std::span(sound).subspan(24064), bentHz), bentHz)) < 0.5);
}

TEST_CASE("Notes that share an object follow the last note's bend") {
    const auto instrument = plate();
    const double lowestHz =
        std::sqrt(instrument->slots()[0].object->eigenvalues[0]) / (2 * std::numbers::pi);
    Player player(instrument, sampleRateHz);
    const auto sound = render(player,
                              {midi(0, 0x91, 60, 100), midi(0, 0xe1, 0, 66),
                               midi(100, 0x92, 60, 100), midi(100, 0xe2, 0, 60)},
                              24000, 256, withMpe());
    const double bent = 48.0 * (60 * 128 - 8192) / 8192 * 100; // the second note's, which is lower
    CHECK(
        std::abs(cents(soundingHz(std::span(sound).subspan(256), lowestHz * std::exp2(bent / 1200)),
                       lowestHz) -
                 bent) < 2);
}

TEST_CASE("Pressure damps a struck key while it is down") {
    ParameterValues values;
    values.set(ParameterId::releaseTime, 0.2);
    const auto level = [&](int pressure) {
        Player player(bars(), sampleRateHz);
        const auto sound = render(player, {midi(0, 0x90, 69, 100), midi(4799, 0xd0, pressure, 0)},
                                  14640, 256, values);
        return 20 * std::log10(rms(std::span(sound).subspan(14160, 480)));
    };
    const double free = level(0);
    CHECK(level(127) - free == Approx(-60).margin(1)); // as if released
    CHECK(level(64) - free == Approx(-60 * (64.0 / 127) * (64.0 / 127)).margin(1));

    Player lifted(bars(), sampleRateHz), never(bars(), sampleRateHz);
    CHECK(render(lifted, {midi(0, 0x90, 69, 100), midi(100, 0x80, 69, 0), midi(200, 0xd0, 127, 0)},
                 4800, 256, values) ==
          render(never, {midi(0, 0x90, 69, 100), midi(100, 0x80, 69, 0)}, 4800, 256, values));
}

TEST_CASE("Pressure ends with its own key, or with Reset All Controllers") {
    ParameterValues values;
    values.set(ParameterId::releaseTime, 0.05);
    const auto level = [&](std::vector<MidiEvent> events) {
        Player player(bars(), sampleRateHz);
        events.insert(events.begin(), midi(0, 0x90, 69, 100));
        events.push_back(midi(64, 0xd0, 127, 0));
        const auto sound = render(player, events, 9600, 256, values);
        return rms(std::span(sound).subspan(9000));
    };
    const double damped = level({});
    Player player(bars(), sampleRateHz);
    const auto reset =
        render(player, {midi(0, 0x90, 69, 100), midi(64, 0xd0, 127, 0), midi(128, 0xb0, 121, 0)},
               9600, 256, values);
    CHECK(rms(std::span(reset).subspan(9000)) > 100 * damped);
    Player stray(bars(), sampleRateHz);
    const auto other =
        render(stray, {midi(0, 0x90, 69, 100), midi(64, 0xd0, 127, 0), midi(128, 0x85, 69, 0)},
               9600, 256, values);
    CHECK(rms(std::span(other).subspan(9000)) <= 2 * damped);
}

TEST_CASE("Polyphonic pressure damps one key, and MPE channel pressure the keys of one channel") {
    ParameterValues values = withMpe();
    values.set(ParameterId::releaseTime, 0.05);
    const auto remains = [&](const MidiEvent& press) {
        Player player(bars(), sampleRateHz), alone(bars(), sampleRateHz);
        const auto both = render(player, {midi(0, 0x91, 69, 100), midi(0, 0x92, 60, 100), press},
                                 9600, 256, values);
        const auto one = render(alone, {midi(0, 0x92, 60, 100)}, 9600, 256, values);
        float most = 0;
        for (std::size_t i = 9000; i < both.size(); ++i)
            most = std::max(most, std::abs(both[i] - one[i]));
        return most / peak(std::span(both).subspan(9000));
    };
    CHECK(remains(midi(64, 0xa1, 69, 127)) < 1e-3f);
    CHECK(remains(midi(64, 0xd1, 127, 0)) < 1e-3f);
    CHECK(remains(midi(64, 0xd3, 127, 0)) > 0.1f);
}

TEST_CASE("CC74 moves the strike position of a key from one end of its path to the other") {
    ParameterValues values;
    values.set(ParameterId::strikeSpread, 0);
    const auto struck = [&](int controller, int channel) {
        Player player(plate(), sampleRateHz);
        return render(player, {midi(0, 0xb0 | channel, 74, controller), midi(0, 0x90, 66, 100)},
                      4800, 256, values);
    };
    const auto atRest = struck(64, 0);
    CHECK(struck(0, 0) != atRest);
    CHECK(struck(0, 0) != struck(127, 0));
    CHECK(struck(0, 5) == atRest);
    Player end(plate(), sampleRateHz);
    CHECK(struck(127, 0) == render(end, {midi(0, 0x90, 96, 100)}, 4800, 256, values));
}

TEST_CASE("CC74 moves strike positions on bars and scaled objects, with MPE on its channel only") {
    const auto [kind, object] = GENERATE(std::pair(KeyMapKind::bars, "xylophone-{note}"),
                                         std::pair(KeyMapKind::scaled, "plate"));
    const bool isMpe = GENERATE(false, true);
    CAPTURE(object, isMpe);
    auto values = isMpe ? withMpe() : ParameterValues();
    values.set(ParameterId::strikeSpread, 0);
    const auto struck = [&](double strikeAt, std::vector<MidiEvent> events) {
        KeyMap map{.kind = kind, .lowestNote = 65, .highestNote = 72, .object = object};
        map.strikeAt = {strikeAt};
        Player player(Instrument::build(map, ObjectLibrary::shared()).value(), sampleRateHz);
        events.push_back(midi(1, 0x93, 68, 100));
        return render(player, events, 4800, 256, values);
    };
    const auto atRest = struck(0.4, {});
    CHECK(struck(0.4, {midi(0, 0xb3, 74, 64)}) == atRest);
    CHECK(struck(0.4, {midi(0, 0xb3, 74, 0)}) == struck(0, {}));
    CHECK(struck(0.4, {midi(0, 0xb3, 74, 127)}) == struck(1, {}));
    CHECK(struck(0.4, {midi(0, 0xb3, 74, 127)}) != atRest);
    CHECK(struck(0.4, {midi(0, 0xb5, 74, 127)}) == atRest);
}
