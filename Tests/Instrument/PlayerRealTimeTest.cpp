#include "Instrument/Player.h"
#include "Support/RenderNotes.h"
#include "Support/SyntheticObject.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> allocations{0};
}

void* operator new(std::size_t size) {
    ++allocations;
    if (void* memory = std::malloc(size > 0 ? size : 1))
        return memory;
    throw std::bad_alloc();
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

using namespace idiophone;
using namespace idiophone::test;
using enum ParameterId;

TEST_CASE("Held keys that scrape and roll allocate nothing, however many are held") {
    ObjectLibrary library;
    const auto kept = library.add("bar", syntheticObject({200, 540, 1070, 1800, 2500}));
    KeyMap map;
    map.kind = KeyMapKind::zones;
    map.lowestNote = 40;
    map.highestNote = 100;
    map.object = "bar";
    Player player(Instrument::build(map, library).value(), 48000);
    ParameterValues parameters;
    std::vector<MidiEvent> crowd;
    for (int i = 0; i < 300; ++i) {
        crowd.push_back(midi(i, i % 4 == 3 ? 0x80 : 0x90, 40 + i * 7 % 61, 1 + i % 127));
        crowd.push_back(midi(i, 0xa0, 40 + i % 61, i % 128));
        crowd.push_back(midi(i, 0xd0, i % 128, 0));
        crowd.push_back(midi(i, 0xb0, i % 2 == 0 ? 1 : 74, i % 128));
    }
    StereoSound block(480);
    float loudest = 0;
    const long before = allocations.load();
    for (int round = 0; round < 60; ++round) {
        parameters.set(contact, round % 20 == 19 ? strikeContact : 1 + round / 10 % 2);
        parameters.set(rollCoupling, round % 3 * 50);
        player.process(block,
                       round % 4 == 0 ? std::span<const MidiEvent>(crowd)
                                      : std::span<const MidiEvent>(),
                       parameters);
        loudest = std::max({loudest, peak(block.left), peak(block.right)});
    }
    const long during = allocations.load() - before;
    CHECK(during == 0);
    CHECK(loudest > 1e-5f);
    CHECK(std::isfinite(loudest));
}

TEST_CASE("Chattering blows with modal pulses allocate nothing, however many come at once") {
    ObjectLibrary library;
    const auto kept = library.add("bar", syntheticObject({200, 540, 1070, 1800, 2500}));
    KeyMap map;
    map.kind = KeyMapKind::scaled;
    map.lowestNote = 40;
    map.highestNote = 100;
    map.object = "bar";
    Player player(Instrument::build(map, library).value(), 48000);
    ParameterValues parameters;
    parameters.set(chatter, 100);
    std::vector<MidiEvent> crowd;
    for (int i = 0; i < 300; ++i)
        crowd.push_back(midi(i % 100 == 0 ? i : i - i % 100, 0x90, 40 + i % 61, 1 + i % 127));
    StereoSound block(480);
    float loudest = 0;
    const long before = allocations.load();
    for (int round = 0; round < 80; ++round) {
        parameters.set(mallet, round % 8);
        parameters.set(modalPulse, round % 3 == 0 ? 1 : 0);
        player.process(block,
                       round % 4 == 0 ? std::span<const MidiEvent>(crowd)
                                      : std::span<const MidiEvent>(),
                       parameters);
        loudest = std::max({loudest, peak(block.left), peak(block.right)});
    }
    const long during = allocations.load() - before;
    CHECK(during == 0);
    CHECK(loudest > 0.001f);
    CHECK(std::isfinite(loudest));
}
