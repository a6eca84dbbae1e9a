// Tests players with several outputs: which slot sounds where, and that nothing is lost or added.
#include "Instrument/SlotOutputs.h"
#include "Instrument/ObjectLibrary.h"
#include "Instrument/Player.h"
#include "Support/AllocationCounter.h"
#include "Support/Level.h"
#include "Support/RenderNotes.h"
#include "Support/WithParameter.h"
#include "TestInstruments.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <catch2/generators/catch_generators.hpp>
#include <cmath>

using namespace idiophone;
using namespace idiophone::test;

namespace {

constexpr double sampleRateHz = 48000;
constexpr std::size_t length = 9600;
const auto all = OutputSet().set();

ParameterValues valuesOf(int choice, int contact = strikeContact) {
    return with(with(with({}, ParameterId::strikeSpread, 0), ParameterId::outputs, choice),
                ParameterId::contact, contact);
}

/// Nine parts on keys 60 to 68, each of one mode.
std::shared_ptr<const Instrument> kit(const std::vector<int>& outputs = {},
                                      const std::vector<int>& chokeGroups = {}) {
    ObjectLibrary library;
    std::vector<KitPart> parts;
    std::vector<std::shared_ptr<const ModalObject>> kept;
    for (int part = 0; part < 9; ++part) {
        const auto name = "part " + std::to_string(part);
        kept.push_back(library.add(name, syntheticObject({300.0 + 110 * part})));
        parts.push_back({.keyMap = {.kind = KeyMapKind::zones,
                                    .lowestNote = 60 + part,
                                    .highestNote = 60 + part,
                                    .object = name}});
        const auto number = static_cast<std::size_t>(part);
        if (number < outputs.size())
            parts.back().output = outputs[number];
        if (number < chokeGroups.size())
            parts.back().chokeGroup = chokeGroups[number];
    }
    return Instrument::build(kitOf(std::move(parts)), library).value();
}

using Outputs = std::vector<StereoSound>; ///< [maximumOutputs]; empty if not connected

/// A block's values and input may depend on the sample at which it starts.
template <class ValuesAt>
Outputs renderAll(Player& player,
                  OutputSet connected,
                  const std::vector<MidiEvent>& events,
                  std::size_t blockSize,
                  const ValuesAt& valuesAt,
                  std::span<const float> input = {}) {
    Outputs sounds;
    for (std::size_t output = 0; output < maximumOutputs; ++output)
        sounds.emplace_back(connected[output] ? length : 0);
    auto event = events.begin();
    for (std::size_t start = 0; start < length; start += blockSize) {
        const auto count = std::min(blockSize, length - start);
        std::vector<StereoSpan> spans;
        for (auto& sound : sounds)
            spans.push_back(sound.left.empty() ? StereoSpan{}
                                               : StereoSpan(sound).subspan(start, count));
        std::vector<MidiEvent> block;
        for (;
             event != events.end() && static_cast<std::size_t>(event->sampleOffset) < start + count;
             ++event) {
            block.push_back(*event);
            block.back().sampleOffset -= static_cast<int>(start);
        }
        player.process(spans, block, valuesAt(start),
                       input.empty() ? input : input.subspan(start, count));
    }
    return sounds;
}

Outputs played(const std::shared_ptr<const Instrument>& instrument,
               OutputSet connected,
               const std::vector<MidiEvent>& events,
               const ParameterValues& values,
               std::span<const float> input = {},
               std::size_t blockSize = 480) {
    Player player(instrument, sampleRateHz);
    return renderAll(
        player, connected, events, blockSize, [&](std::size_t) { return values; }, input);
}

StereoSound sumOf(const Outputs& outputs) {
    StereoSound sum(length);
    for (const auto& output : outputs)
        for (std::size_t i = 0; i < output.left.size(); ++i) {
            sum.left[i] += output.left[i];
            sum.right[i] += output.right[i];
        }
    return sum;
}

float loudestDifference(const StereoSound& one, const StereoSound& other) {
    float loudest = 0;
    for (std::size_t i = 0; i < one.left.size(); ++i)
        loudest = std::max({loudest, std::abs(one.left[i] - other.left[i]),
                            std::abs(one.right[i] - other.right[i])});
    return loudest;
}

/// Returns the output that sounds after a note, if it is the only one.
int outputHeard(const std::shared_ptr<const Instrument>& instrument, int note, int choice) {
    const auto outputs = played(instrument, all, {midi(0, 0x90, note, 100)}, valuesOf(choice));
    int heard = -1;
    for (std::size_t output = 0; output < maximumOutputs; ++output)
        if (peak(outputs[output].left) > 0) {
            CHECK(heard == -1);
            heard = static_cast<int>(output);
        }
    return heard;
}

} // namespace

TEST_CASE("Parts of a kit go round the outputs, or to those that they name") {
    const auto round = kit(), named = kit({0, 8, 0, 1});
    for (int part = 0; part < 9; ++part) {
        INFO(part);
        CHECK(outputHeard(round, 60 + part, mainOutput) == 0);
        CHECK(outputHeard(round, 60 + part, outputsByPart) == part % 8);
        CHECK(outputHeard(named, 60 + part, outputsByPart) == (part == 1   ? 7
                                                               : part == 3 ? 0
                                                                           : part % 8));
    }
    CHECK(outputHeard(bars(), 67, outputsByPart) == 0);
}

TEST_CASE("Octaves and keys choose the outputs from C1 and C2 on, and middle C's is the fourth") {
    const auto keyboard = keysOn(syntheticObject({440}), KeyMapKind::scaled, 0, 127);
    for (const auto& [note, octave] : {std::pair(22, 0),
                                       {23, 0},
                                       {24, 0},
                                       {35, 0},
                                       {36, 1},
                                       {60, 3},
                                       {71, 3},
                                       {72, 4},
                                       {107, 6},
                                       {108, 7},
                                       {127, 7}})
        CHECK(outputHeard(keyboard, note, outputsByOctave) == octave);
    for (int note = 36; note < 46; ++note)
        CHECK(outputHeard(keyboard, note, outputsByKey) == (note - 36) % 8);
    // An object that several keys strike is on the output of the lowest.
    const auto shared = keysOn(syntheticObject({440}), KeyMapKind::zones, 48, 96);
    CHECK(outputHeard(shared, 90, outputsByOctave) == 2);
}

TEST_CASE("All that a slot sounds comes from its output, and the outputs add up to the sound") {
    const int contact = GENERATE(strikeContact, scrapeContact, rollContact, bowContact);
    const bool isDriven = GENERATE(false, true);
    const std::vector events{midi(100, 0x90, 60, 100), midi(1000, 0x90, 61, 90),
                             midi(1500, 0x90, 62, 80), midi(3000, 0xd0, 127, 0),
                             midi(5000, 0x80, 61, 0)};
    std::vector<float> input;
    if (isDriven)
        for (std::size_t i = 0; i < length; ++i)
            input.push_back(std::sin(0.04f * static_cast<float>(i)));
    CAPTURE(contact, isDriven);
    const auto instrument = kit({}, {1, 1});
    const auto play = [&](int choice) {
        Player player(instrument, sampleRateHz);
        player.setSilencedModes({});
        player.strikeSurface({.slot = 4, .point = {}, .velocity = 100});
        return renderAll(
            player, all, events, 480,
            [&](std::size_t) { return with(valuesOf(choice, contact), ParameterId::letRing, 0); },
            input);
    };
    const auto main = play(mainOutput).front(), sum = sumOf(play(outputsByPart));
    REQUIRE(peak(main.left) > 0);
    CHECK(loudestDifference(sum, main) < 1e-5f * peak(main.left));
    const auto outputs = play(outputsByPart);
    for (std::size_t output = 0; output < maximumOutputs; ++output)
        CHECK((peak(outputs[output].left) > 0) == (output < 3 || (output == 4)));
}

TEST_CASE("Without further outputs every choice is bit-identical to the main output alone") {
    const std::vector events{midi(0, 0x90, 60, 100), midi(1000, 0x90, 63, 90)};
    const auto expected = played(kit(), 1, events, valuesOf(mainOutput)).front();
    for (const int choice : {outputsByPart, outputsByOctave, outputsByKey})
        CHECK(played(kit(), 1, events, valuesOf(choice)).front() == expected);
    const auto alone = played(kit(), all, events, valuesOf(mainOutput));
    CHECK(alone.front() == expected);
    // Outputs that are not connected sound on the main one.
    const auto some = played(kit(), OutputSet().set(0).set(3), events, valuesOf(outputsByPart));
    const auto first = played(kit(), 1, {events.front()}, valuesOf(mainOutput)).front();
    CHECK(some.front() == first);
    CHECK(peak(some[3].left) > 0);
}

TEST_CASE("Eight outputs are the same bits in blocks of every size, and never allocate") {
    std::vector<MidiEvent> events;
    for (int i = 0; i < 40; ++i)
        events.push_back(midi(i * 231, 0x90, 60 + i * 5 % 9, 1 + i * 29 % 127));
    events.push_back(midi(9400, 0xb0, 120, 0));
    events.push_back(midi(9420, 0x90, 64, 100));
    const auto instrument = kit();
    const auto values = valuesOf(outputsByPart);
    const auto expected = played(instrument, all, events, values, {}, 512);
    for (std::size_t output = 0; output < maximumOutputs; ++output)
        CHECK(peak(expected[output].left) > 0);
    for (const std::size_t blockSize : {1u, 7u, 64u, 480u, 1000u, 8192u}) {
        INFO("blocks of " << blockSize);
        CHECK(played(instrument, all, events, values, {}, blockSize) == expected);
    }

    Player player(instrument, sampleRateHz);
    Outputs sounds(maximumOutputs, StereoSound(480));
    const std::vector<StereoSpan> spans(sounds.begin(), sounds.end());
    const AllocationCounter counter;
    for (int block = 0; block < 40; ++block)
        player.process(std::span(spans).first(block % 3 == 0 ? 4 : 8), {events.data(), 3},
                       with(values, ParameterId::outputs, block % outputChoices));
    CHECK(counter.allocations() == 0);
}

TEST_CASE("A change of the outputs fades all sound for one cell, and moves it without a step") {
    const auto instrument = kit();
    const std::vector note{midi(0, 0x90, 62, 100)};
    const auto changed = [&](int to) {
        Player player(instrument, sampleRateHz);
        return renderAll(player, all, note, 480, [&](std::size_t start) {
            return valuesOf(start < 4800 ? mainOutput : to);
        });
    };
    const auto kept = changed(mainOutput), moved = changed(outputsByPart);
    const auto sum = sumOf(moved), expected = sumOf(kept);
    for (std::size_t i = 0; i < length; ++i) {
        INFO(i);
        REQUIRE(std::abs(sum.left[i]) <= std::abs(expected.left[i]));
        if (i < 4800 || i >= 4800 + 2 * cellSamples)
            REQUIRE(sum.left[i] == expected.left[i]);
    }
    const float step = peak(expected.left) / 10; // of 520 Hz and of the fade
    for (const std::size_t output : {0u, 2u})
        for (std::size_t i = 4800; i < 4800 + 3 * cellSamples; ++i)
            REQUIRE(std::abs(moved[output].left[i] - moved[output].left[i - 1]) < step);
    CHECK(peak(std::span(moved[0].left).subspan(5000)) == 0);
    CHECK(peak(std::span(moved[2].left).subspan(5000)) > 0);
    // Parts that all name the main output do not move, so nothing fades.
    const auto main = kit(std::vector(9, 1));
    Player player(main, sampleRateHz);
    const auto still = renderAll(player, all, note, 480, [&](std::size_t start) {
        return valuesOf(start < 4800 ? mainOutput : outputsByPart);
    });
    CHECK(still.front() == kept.front());
}

TEST_CASE(
    "A strike chokes a part on another output, and after All Sound Off the rest fades there") {
    const auto instrument = kit({}, {1, 1});
    const std::vector ringing{midi(0, 0x90, 60, 100)};
    auto choking = ringing, silencing = ringing;
    choking.push_back(midi(4800, 0x90, 61, 100));
    silencing.push_back(midi(4800, 0xb0, 120, 0));
    silencing.push_back(midi(4805, 0x90, 63, 100));
    const auto values = valuesOf(outputsByPart);
    const auto free = played(instrument, all, ringing, values);
    const auto choked = played(instrument, all, choking, values);
    const auto silenced = played(instrument, all, silencing, values);
    const auto tail = [](const Outputs& outputs, std::size_t output) {
        return peak(std::span(outputs[output].left).last(1920));
    };
    CHECK(tail(choked, 0) < 0.02f * tail(free, 0));
    CHECK(tail(choked, 1) > 0.1f * tail(free, 0));
    CHECK(tail(silenced, 0) == 0);
    CHECK(tail(silenced, 3) > 0.1f * tail(free, 0));
    CHECK(loudestDifference(sumOf(silenced), played(instrument, 1, silencing, values).front()) <
          1e-5f * peak(free.front().left));
}
