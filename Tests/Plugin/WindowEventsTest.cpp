#include "Plugin/WindowEvents.h"

#include <atomic>
#include <catch2/catch_test_macros.hpp>
#include <thread>
#include <vector>

using namespace idiophone;

namespace {

/// Returns the notes read, releases as negative numbers.
std::vector<int> readAll(WindowEvents& events) {
    std::vector<int> notes;
    events.read(nullptr, [&](const MidiEvent& event) {
        notes.push_back(event.isNoteOn() ? event.bytes[1] : -event.bytes[1]);
    });
    return notes;
}

} // namespace

TEST_CASE("Notes of the window are read once and in order, at any position of the ring") {
    WindowEvents events;
    for (int turn = 0; turn < 50; ++turn) {
        std::vector<int> sent;
        for (int note = 1; note < 30 + turn; ++note) {
            sent.push_back(note);
            CHECK(events.pushNote(note, 100));
        }
        CHECK(readAll(events) == sent);
        CHECK(readAll(events).empty());
    }
}

TEST_CASE("A full queue refuses notes and takes them again after a read") {
    WindowEvents events;
    std::size_t pushed = 0;
    while (events.pushNote(static_cast<int>(pushed % 128), 100))
        ++pushed;
    CHECK(pushed == WindowEvents::capacity);
    CHECK(readAll(events).size() == pushed);
    CHECK(events.pushNote(60, 100));
}

TEST_CASE("If a key release does not fit the queue, all held keys are released") {
    WindowEvents events;
    events.pushNote(70, 100);
    events.pushNote(71, 100);
    events.pushNote(71, 0);
    while (events.pushNote(60, 100)) {
    }
    CHECK_FALSE(events.pushNote(60, 0));
    auto read = readAll(events);
    CHECK(read.size() == WindowEvents::capacity + 2);
    CHECK(std::vector(read.end() - 2, read.end()) == std::vector{-60, -70});
    events.pushNote(61, 100);
    CHECK(readAll(events) == std::vector{61});
}

TEST_CASE("Silence ends the sound once, behind the notes before it, even if the queue is full") {
    WindowEvents events;
    while (events.pushNote(60, 100)) {
    }
    events.silence();
    std::vector<MidiEvent> read;
    const auto keep = [&](const MidiEvent& event) { read.push_back(event); };
    events.read(nullptr, keep);
    REQUIRE(read.size() == WindowEvents::capacity + 1);
    CHECK(read.back().bytes == std::array<std::uint8_t, 3>{0xb0, 120, 0});
    CHECK(readAll(events).empty());
}

TEST_CASE("Cleared events are not read, and no key counts as held") {
    WindowEvents events;
    events.pushNote(60, 100);
    readAll(events);
    while (events.pushNote(61, 100)) {
    }
    events.pushNote(61, 0);
    events.clear();
    CHECK(readAll(events).empty());
}

TEST_CASE("Between threads notes arrive in order and without loss") {
    constexpr int last = 20'000;
    WindowEvents events;
    std::atomic<bool> isAllSent{false};
    std::thread sender([&] {
        for (int number = 0; number < last; ++number)
            while (!events.pushNote(number % 128, 1 + number % 127))
                std::this_thread::yield();
        isAllSent = true;
    });
    int seen = 0;
    bool isInOrder = true;
    for (bool isOver = false; !isOver;) {
        isOver = isAllSent; // the last notes are read in this round
        events.read(nullptr, [&](const MidiEvent& event) {
            isInOrder =
                isInOrder && event.bytes[1] == seen % 128 && event.bytes[2] == 1 + seen % 127;
            ++seen;
        });
        std::this_thread::yield();
    }
    sender.join();
    CHECK(seen == last);
    CHECK(isInOrder);
}
