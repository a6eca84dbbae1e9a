#include "Plugin/PendingKeys.h"

#include <catch2/catch_test_macros.hpp>
#include <vector>

using namespace idiophone;

namespace {

constexpr int programs = 3;

MidiEvent message(int status, int first, int second = 0) {
    return {.sampleOffset = 7,
            .bytes = {static_cast<std::uint8_t>(status), static_cast<std::uint8_t>(first),
                      static_cast<std::uint8_t>(second)}};
}

struct Struck {
    int channel, note, velocity;
    bool operator==(const Struck&) const = default;
};

std::vector<Struck> taken(PendingKeys& keys) {
    std::vector<Struck> result;
    for (const auto& event : keys.take()) {
        CHECK(event.isNoteOn());
        CHECK(event.sampleOffset == 0);
        result.push_back({event.bytes[0] & 0x0f, event.bytes[1], event.bytes[2]});
    }
    return result;
}

std::vector<Struck> takenAfter(std::initializer_list<MidiEvent> messages) {
    PendingKeys keys(programs);
    keys.follow(std::vector(messages));
    return taken(keys);
}

const auto change = message(0xc0, 2);

} // namespace

TEST_CASE("Keys pressed after a program change and still held are struck again in order") {
    CHECK(takenAfter({message(0x90, 50, 9), change, message(0x93, 60, 100), message(0x90, 62, 90),
                      message(0x90, 64, 80), message(0x80, 62), message(0x90, 60, 70)}) ==
          std::vector<Struck>{{3, 60, 100}, {0, 64, 80}, {0, 60, 70}});
    CHECK(takenAfter({change, message(0x90, 60, 100), message(0x90, 60, 0)}).empty());
    CHECK(takenAfter({change, message(0x90, 60, 100), message(0x80, 60, 64),
                      message(0x90, 60, 50)}) == std::vector<Struck>{{0, 60, 50}});
}

TEST_CASE("Without a request for an existing program nothing is struck again") {
    CHECK(takenAfter({message(0x90, 60, 100)}).empty());
    CHECK(takenAfter({message(0xc0, programs), message(0x90, 60, 100)}).empty());
    CHECK(takenAfter({change, message(0x90, 60, 100), message(0xc9, programs)}).size() == 1);
}

TEST_CASE("The last requested program that exists is returned once") {
    PendingKeys keys(programs);
    CHECK_FALSE(keys.takeProgram());
    keys.follow(std::vector{message(0xc0, 0), message(0xc3, 2), message(0xc9, programs),
                            message(0x90, 1, 1), message(0xb0, 1, 1)});
    CHECK(keys.takeProgram() == 2);
    CHECK_FALSE(keys.takeProgram());
}

TEST_CASE("After take, no key is pending") {
    PendingKeys keys(programs);
    const std::vector messages{change, message(0x90, 60, 100)};
    keys.follow(messages);
    CHECK(taken(keys).size() == 1);
    CHECK(taken(keys).empty());
    keys.follow(std::span(messages).last(1));
    CHECK(taken(keys).empty());
}

TEST_CASE("After forgetKeys, later keys are still pending") {
    PendingKeys keys(programs);
    keys.follow(std::vector{change, message(0x90, 60, 100)});
    keys.forgetKeys();
    keys.follow(std::vector{message(0x90, 62, 90)});
    CHECK(taken(keys) == std::vector<Struck>{{0, 62, 90}});
}

TEST_CASE("A second program change and All Notes Off clear the pending keys") {
    CHECK(takenAfter({change, message(0x90, 60, 100), message(0xc0, 0)}).empty());
    for (const int controller : {120, 123, 124, 127})
        CHECK(takenAfter({change, message(0x90, 60, 100), message(0xb0, controller)}).empty());
    CHECK(takenAfter({change, message(0x90, 60, 100), message(0xb0, 121)}).size() == 1);
    CHECK(takenAfter({change, message(0x90, 60, 100), message(0xe0, 123)}).size() == 1);
}

TEST_CASE("If the queue of pending keys is full, the first keys are kept") {
    PendingKeys keys(programs);
    keys.follow(std::vector{change});
    for (int channel = 0; channel < 16; ++channel)
        for (int note = 0; note < 128; ++note)
            keys.follow(std::vector{message(0x90 | channel, note, 1)});
    CHECK(taken(keys).size() == 256);
}
