// Tests All Sound Off (controller 120): the sound ends, and no later strike restores it.
#include "HeldKeys.h"
#include "Instrument/Player.h"
#include "SameInAllBlocks.h"
#include "Support/Larger.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "TestInstruments.h"

#include <array>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>
#include <optional>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;

ParameterValues steadyHand() {
    ParameterValues parameters;
    parameters.set(ParameterId::strikeSpread, 0);
    parameters.set(ParameterId::radiation, 0);
    return parameters;
}

MidiEvent allSoundOff(int sample) {
    return midi(sample, 0xb0, 120, 0);
}

float largestDifference(std::span<const float> one, std::span<const float> other) {
    float most = 0;
    for (std::size_t i = 0; i < one.size(); ++i)
        most = larger(most, std::abs(one[i] - other[i]));
    return most;
}

float steepest(std::span<const float> sound) {
    float most = 0;
    for (std::size_t i = 1; i < sound.size(); ++i)
        most = larger(most, std::abs(sound[i] - sound[i - 1]));
    return most;
}

} // namespace

TEST_CASE("All Sound Off silences within 50 ms, and the next note sounds again") {
    Player player(bars(), sampleRateHz);
    const auto sound = render(player,
                              {midi(0, 0x90, 69, 127), midi(0, 0x90, 60, 127),
                               midi(4800, 0xb0, 120, 0), midi(9600, 0x90, 69, 127)},
                              14400, 256);
    CHECK(peak(std::span(sound).subspan(7200, 2400)) < 1e-4f * peak(sound));
    CHECK(peak(std::span(sound).subspan(9600)) > 0.5f * peak(sound));
}

TEST_CASE("Sound from before All Sound Off does not ring on during the next note") {
    const int off = GENERATE(4800, 4831, 4863), gap = GENERATE(0, 10, 144, 960);
    const int note = GENERATE(69, 60);
    CAPTURE(off, gap, note);
    const auto soft = midi(off + gap, 0x90, note, 1);
    Player player(bars(), sampleRateHz), alone(bars(), sampleRateHz);
    const auto sound =
        render(player, {midi(0, 0x90, 69, 127), allSoundOff(off), soft}, 9600, 480, steadyHand());
    const auto expected = render(alone, {soft}, 9600, 480, steadyHand());
    const auto gone = static_cast<std::size_t>(off + gap) + 2 * cellSamples;
    CHECK(peak(std::span(expected).subspan(gone)) > 0);
    CHECK(largestDifference(std::span(sound).subspan(gone), std::span(expected).subspan(gone)) <
          1e-6f * peak(sound));
    const auto around = std::span(sound).subspan(static_cast<std::size_t>(off + gap) - 1);
    CHECK(steepest(around) < 1.5f * steepest(std::span(sound).subspan(2400, 2000)));
}

TEST_CASE("After All Sound Off has silenced everything, a note is as loud as without it") {
    const double rateHz = GENERATE(22050.0, 48000.0);
    const bool rangBefore = GENERATE(false, true);
    for (const int later : {0, 19, 20, 21, 40, 83, 84}) {
        const auto note = midi((rangBefore ? 9600 : 300) + later, 0x90, 60, 100);
        CAPTURE(rateHz, rangBefore, note.sampleOffset);
        std::vector events{midi(0, 0x90, 69, 127), allSoundOff(100), note};
        if (!rangBefore)
            events.erase(events.begin());
        Player player(bars(), rateHz), alone(bars(), rateHz);
        const auto sound = render(player, events, 14400, 480, steadyHand());
        const auto expected = render(alone, {note}, 14400, 480, steadyHand());
        const auto from = static_cast<std::size_t>(note.sampleOffset);
        CHECK(largestDifference(std::span(sound).subspan(from), std::span(expected).subspan(from)) <
              1e-6f * peak(expected));
    }
}

TEST_CASE("All Sound Off before a note at the same sample is the same for all block sizes") {
    std::vector<MidiEvent> events;
    for (const int time : {700, 1000, 1001, 1100, 1120, 3000, 3840, 5011}) {
        events.push_back(allSoundOff(time));
        events.push_back(midi(time, 0x90, 60 + time % 13, 1 + time % 100));
        events.push_back(midi(time + (time % 7 == 0), 0x90, 61, 90));
    }
    const auto sound =
        checkSameInBlocksOf({1, 7, 64, 480, 4096}, bars(), sampleRateHz, events, 8000, {});
    CHECK(peak(sound.left) > 0.001f);
}

TEST_CASE("A note before All Sound Off at the same sample is silent, and one after it sounds") {
    const int at = GENERATE(0, 100);
    const auto before = midi(at, 0x90, 69, 127), after = midi(at, 0x90, 60, 20);
    Player player(bars(), sampleRateHz), alone(bars(), sampleRateHz);
    CHECK(render(player, {before, allSoundOff(at), after}, 4800, 480, steadyHand()) ==
          render(alone, {after}, 4800, 480, steadyHand()));
}

TEST_CASE("A player reports the silenced samples at the start of a block, up to the next strike") {
    using Silenced = std::optional<std::size_t>;
    Player player(bars(), sampleRateHz);
    const auto silencedIn = [&](const std::vector<MidiEvent>& events, int samples) {
        render(player, events, static_cast<std::size_t>(samples),
               static_cast<std::size_t>(samples));
        return player.takeSilenced();
    };
    CHECK(silencedIn({midi(0, 0x90, 69, 127)}, 480) == Silenced());
    CHECK(silencedIn({allSoundOff(0), midi(300, 0x90, 60, 90)}, 480) == Silenced(300));
    CHECK(silencedIn({}, 480) == Silenced());
    CHECK(silencedIn({allSoundOff(0)}, 480) == Silenced(480));
    CHECK(silencedIn({}, 100) == Silenced(100));
    CHECK(silencedIn({midi(70, 0x80, 60, 0), midi(77, 0x90, 60, 90)}, 480) == Silenced(77));
    CHECK(silencedIn({}, 480) == Silenced());
    // A note at its sample sounds, but effects behind the player must end the old sound.
    CHECK(silencedIn({allSoundOff(0), midi(0, 0x90, 60, 90)}, 480) == Silenced(0));
    CHECK(player.takeSilenced() == Silenced());
    player.process(StereoSpan{}, std::vector{allSoundOff(0)}, {});
    CHECK(player.takeSilenced() == Silenced(0));
    CHECK(silencedIn({}, 480) == Silenced(480));
    player.reset();
    CHECK(player.takeSilenced() == Silenced());
}

TEST_CASE("A scrape that All Sound Off ends is not heard during the next note") {
    const int off = GENERATE(9600, 9631), gap = GENERATE(0, 200);
    CAPTURE(off, gap);
    const auto instrument = keysOn(syntheticObject({300, 810}), KeyMapKind::scaled, 40, 80);
    const auto next = midi(off + gap, 0x90, 60, 1);
    const auto sound = play(instrument, {midi(0, 0x90, 60, 127), allSoundOff(off), next}, 14400);
    const auto expected = play(instrument, {next}, 14400);
    const auto gone = static_cast<std::size_t>(off + gap) + 2 * cellSamples;
    CHECK(largestDifference(std::span(sound).subspan(gone), std::span(expected).subspan(gone)) <
          1e-6f * peak(sound));
}

TEST_CASE("A reset leaves nothing of earlier notes and controllers") {
    Player player(bars(), sampleRateHz), fresh(bars(), sampleRateHz);
    const std::vector messages{
        midi(0, 0x90, 69, 127),  midi(0, 0x90, 60, 127),  midi(10, 0xb0, 64, 127),
        midi(10, 0xb0, 66, 127), midi(10, 0xb0, 67, 127), midi(10, 0xb0, 1, 3),
        midi(10, 0xb0, 74, 3),   midi(10, 0xe0, 0, 100),  midi(10, 0xd0, 90, 0),
        allSoundOff(4700),       midi(4700, 0x90, 64, 90)};
    render(player, messages, 4710, 471);
    player.reset();
    CHECK(player.silent());
    // A hand adds a strike, which no note brings to its pitch.
    const auto& key = player.instrument().key(65);
    for (auto* each : {&player, &fresh})
        each->strikeSurface({.slot = static_cast<std::size_t>(key.slot),
                             .point = key.strip->between(key.along, 0).point,
                             .velocity = 100});
    const std::vector phrase{midi(0, 0x90, 69, 100), midi(100, 0x80, 69, 0),
                             midi(200, 0x90, 60, 100), midi(300, 0x80, 60, 0)};
    ParameterValues damped;
    damped.set(ParameterId::letRing, 0);
    CHECK(renderStereo(player, phrase, 9600, 480, damped) ==
          renderStereo(fresh, phrase, 9600, 480, damped));
}
