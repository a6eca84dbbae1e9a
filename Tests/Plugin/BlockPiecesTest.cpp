#include "Plugin/BlockPieces.h"

#include <algorithm>
#include <array>
#include <catch2/catch_test_macros.hpp>
#include <random>
#include <vector>

using namespace idiophone;

namespace {

struct Cut {
    std::vector<int> lengths;
    std::vector<std::pair<int, int>> notes; ///< sample in the block, note
    bool contiguous = true;
    bool inside = true;
};

Cut cut(const juce::MidiBuffer& midi, int samples, std::span<const MidiEvent> added = {}) {
    BlockPieces pieces;
    pieces.begin(midi, samples);
    for (const auto& event : added)
        pieces.add(event);
    Cut result;
    int position = 0;
    while (const auto piece = pieces.next()) {
        result.contiguous = result.contiguous && piece->start == position;
        position += piece->length;
        result.lengths.push_back(piece->length);
        int last = 0;
        for (const auto& event : piece->events) {
            result.inside = result.inside && event.sampleOffset >= last &&
                            (event.sampleOffset < piece->length ||
                             (piece->length == 0 && event.sampleOffset == 0));
            last = event.sampleOffset;
            result.notes.emplace_back(piece->start + event.sampleOffset, event.bytes[1]);
        }
    }
    result.contiguous = result.contiguous && position == samples;
    return result;
}

juce::MidiMessage note(int number) {
    return juce::MidiMessage::noteOn(1, number, static_cast<juce::uint8>(100));
}

} // namespace

TEST_CASE("A block that fits is one piece with all its channel messages") {
    juce::MidiBuffer midi;
    midi.addEvent(note(60), 0);
    midi.addEvent(note(61), 255);
    const auto result = cut(midi, 256);
    CHECK(result.lengths == std::vector{256});
    CHECK(result.notes == std::vector<std::pair<int, int>>{{0, 60}, {255, 61}});
    CHECK(result.inside);
}

TEST_CASE("All Sound Off starts a piece, together with the other events of its sample") {
    juce::MidiBuffer midi;
    midi.addEvent(note(60), 0);
    midi.addEvent(note(61), 100);
    for (const int channel : {1, 2})
        midi.addEvent(juce::MidiMessage::allSoundOff(channel), 100);
    midi.addEvent(note(62), 100);
    midi.addEvent(juce::MidiMessage::allNotesOff(1), 200);
    midi.addEvent(juce::MidiMessage::allSoundOff(16), 255);
    const auto result = cut(midi, 256);
    CHECK(result.lengths == std::vector{100, 155, 1});
    CHECK(result.notes ==
          std::vector<std::pair<int, int>>{
              {0, 60}, {100, 61}, {100, 120}, {100, 120}, {100, 62}, {200, 123}, {255, 120}});
    CHECK(result.inside);
    CHECK(result.contiguous);
}

TEST_CASE("An overlong block is cut, and every event keeps its sample") {
    juce::MidiBuffer midi;
    for (int stamp = 0; stamp < 10000; stamp += 97)
        midi.addEvent(note(stamp / 97 % 128), stamp);
    const auto result = cut(midi, 10000);
    CHECK(result.contiguous);
    CHECK(result.inside);
    REQUIRE(result.notes.size() == 104);
    for (std::size_t i = 0; i < result.notes.size(); ++i)
        CHECK(result.notes[i].first == static_cast<int>(i) * 97);
    for (const int length : result.lengths)
        CHECK(length <= BlockPieces::maximumSamples);
}

TEST_CASE("Events on one sample that overfill a piece keep their sample and their order") {
    constexpr int crowd = 3 * BlockPieces::maximumEvents + 5;
    for (const int stamp : {0, 100, 511}) {
        juce::MidiBuffer midi;
        midi.addEvent(note(127), 0);
        for (int i = 0; i < crowd; ++i)
            midi.addEvent(note(i % 128), stamp);
        const auto result = cut(midi, 512);
        INFO("all on sample " << stamp);
        CHECK(result.contiguous);
        CHECK(result.inside);
        REQUIRE(result.notes.size() == crowd + 1);
        bool right = true;
        for (int i = 0; i < crowd; ++i)
            right =
                right && result.notes[static_cast<std::size_t>(i) + 1] == std::pair(stamp, i % 128);
        CHECK(right);
    }
}

TEST_CASE("Events of blocks without samples are kept in order for the next block") {
    BlockPieces pieces;
    juce::MidiBuffer first, second;
    first.addEvent(note(60), 0);
    second.addEvent(note(61), 0);
    for (const auto* midi : {&first, &second}) {
        pieces.begin(*midi, 0);
        CHECK_FALSE(pieces.next());
    }
    pieces.begin(second, 64);
    const auto piece = pieces.next();
    REQUIRE(piece);
    REQUIRE(piece->events.size() == 3);
    CHECK(piece->length == 64);
    CHECK(piece->events[0].bytes[1] == 60);
    CHECK(piece->events[2].bytes[1] == 61);
    CHECK_FALSE(pieces.next());
}

TEST_CASE("Kept events are handed on before the store is full, and reset discards them") {
    BlockPieces pieces;
    juce::MidiBuffer midi, none;
    for (int i = 0; i < 3000; ++i)
        midi.addEvent(note(i % 128), 0);
    std::size_t handedOn = 0;
    for (int block = 0; block < 10; ++block) {
        pieces.begin(midi, 0);
        while (const auto piece = pieces.next())
            handedOn += piece->events.size();
    }
    CHECK(handedOn > 0);
    pieces.begin(none, 64);
    CHECK(handedOn + pieces.next()->events.size() == 30000);
    pieces.begin(midi, 0);
    CHECK_FALSE(pieces.next());
    pieces.reset();
    pieces.begin(none, 64);
    CHECK(pieces.next()->events.empty());
}

TEST_CASE("Notes and system exclusive messages of one block keep their samples and their order") {
    const juce::uint8 dump[]{1, 2, 3};
    std::mt19937 random(1);
    for (const int samples : {0, 1, 300, 5000}) {
        juce::MidiBuffer midi;
        std::vector<std::pair<int, int>> expected; // sample, note or −1
        int stamp = 0;
        for (int i = 0; i < 2000; ++i) {
            stamp = std::min(stamp + (random() % 8 == 0 ? 1 : 0), std::max(samples - 1, 0));
            const bool isNote = random() % 3 != 0;
            const int number = static_cast<int>(random() % 128);
            midi.addEvent(isNote ? note(number) : juce::MidiMessage::createSysExMessage(dump, 3),
                          stamp);
            expected.emplace_back(stamp, isNote ? number : -1);
        }
        BlockPieces pieces;
        pieces.begin(midi, samples);
        std::vector<std::pair<int, int>> found;
        const auto take = [&] {
            const auto piece = pieces.next();
            if (!piece)
                return false;
            if (!piece->systemExclusive.empty())
                found.emplace_back(piece->start, -1);
            for (const auto& event : piece->events)
                found.emplace_back(piece->start + event.sampleOffset, event.bytes[1]);
            return true;
        };
        while (take()) {
        }
        if (samples == 0) { // the last notes belong to the next block
            const juce::MidiBuffer none;
            pieces.begin(none, 1);
            take();
        }
        CHECK(found == expected);
    }
}

TEST_CASE("System messages are left out") {
    juce::MidiBuffer midi;
    const juce::uint8 dump[]{1, 2, 3, 4, 5};
    midi.addEvent(juce::MidiMessage::createSysExMessage(dump, 5), 3);
    midi.addEvent(juce::MidiMessage::midiClock(), 4);
    midi.addEvent(juce::MidiMessage::songPositionPointer(7), 5);
    midi.addEvent(note(64), 6);
    const auto result = cut(midi, 64);
    CHECK(result.notes == std::vector<std::pair<int, int>>{{6, 64}});
}

TEST_CASE("Events with a time outside their block move to its ends") {
    juce::MidiBuffer midi;
    midi.addEvent(note(60), -5);
    midi.addEvent(note(61), 900);
    const auto result = cut(midi, 64);
    CHECK(result.notes == std::vector<std::pair<int, int>>{{0, 60}, {63, 61}});
}

TEST_CASE("Added events come first, at the first sample, and count towards the limit") {
    juce::MidiBuffer midi;
    midi.addEvent(note(60), 0);
    const std::array added{MidiEvent{.sampleOffset = 0, .bytes = {0x90, 70, 90}},
                           MidiEvent{.sampleOffset = 0, .bytes = {0x80, 70, 0}}};
    const auto result = cut(midi, 64, added);
    CHECK(result.notes == std::vector<std::pair<int, int>>{{0, 70}, {0, 70}, {0, 60}});
    BlockPieces pieces;
    const auto room = pieces.room();
    pieces.begin(midi, 64);
    pieces.add(added[0]);
    CHECK(pieces.room() == room - 1);
}
