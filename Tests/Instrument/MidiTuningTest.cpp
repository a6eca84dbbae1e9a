#include "Instrument/MidiTuning.h"

#include <catch2/catch_test_macros.hpp>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <vector>

using namespace idiophone;

namespace {

using Message = std::vector<std::uint8_t>;

/// Returns a message from F0 to F7 with the parts in order.
Message message(std::initializer_list<Message> parts) {
    Message bytes{0xf0};
    for (const auto& part : parts)
        bytes.insert(bytes.end(), part.begin(), part.end());
    bytes.push_back(0xf7);
    return bytes;
}

const Message name(16, 'n');

double semitonesAfter(const Message& bytes, std::size_t key) {
    MidiTuning tuning;
    CHECK(tuning.read(bytes));
    return tuning.keys().semitonesFromEqual[key];
}

} // namespace

TEST_CASE("Single notes of a program or of a bank's program are tuned") {
    const Message change{69, 70, 64, 0}; // a semitone and a half up
    for (const auto realTime : std::initializer_list<std::uint8_t>{0x7e, 0x7f})
        for (const auto& bytes : {message({{realTime, 3, 8, 2, 5, 1}, change}),
                                  message({{realTime, 3, 8, 7, 1, 5, 1}, change})}) {
            CHECK(semitonesAfter(bytes, 69) == 1.5);
            CHECK(semitonesAfter(bytes, 70) == 0);
        }
}

TEST_CASE("A bulk dump tunes all keys but those that it leaves unchanged") {
    Message pitches;
    for (std::uint8_t key = 0; key < 128; ++key) {
        const Message pitch = key == 60 ? Message{127, 127, 127} : Message{key, 32, 0};
        pitches.insert(pitches.end(), pitch.begin(), pitch.end());
    }
    for (const auto& bytes : {message({{0x7e, 0, 8, 1, 0}, name, pitches, {9}}),
                              message({{0x7e, 0, 8, 4, 0, 0}, name, pitches, {9}})}) {
        CHECK(semitonesAfter(bytes, 0) == 0.25);
        CHECK(semitonesAfter(bytes, 127) == 0.25);
        CHECK(semitonesAfter(bytes, 60) == 0);
    }
}

TEST_CASE("An octave scale tunes each key by its note") {
    Message cents(12, 64), fine;
    cents[9] = 64 - 14; // A
    for (const auto each : cents) {
        const int offset = 8192 + (each - 64) * 8192 / 100;
        fine.push_back(static_cast<std::uint8_t>(offset >> 7));
        fine.push_back(static_cast<std::uint8_t>(offset & 127));
    }
    for (const auto& bytes : {message({{0x7f, 0, 8, 8, 3, 127, 127}, cents}),
                              message({{0x7f, 0, 8, 9, 3, 127, 127}, fine}),
                              message({{0x7e, 0, 8, 5, 0, 0}, name, cents, {9}}),
                              message({{0x7e, 0, 8, 6, 0, 0}, name, fine, {9}})}) {
        CHECK(std::abs(semitonesAfter(bytes, 69) + 0.14) < 2e-4);
        CHECK(std::abs(semitonesAfter(bytes, 9) + 0.14) < 2e-4);
        CHECK(semitonesAfter(bytes, 70) == 0);
    }
}

TEST_CASE("Other messages, and what is cut off, tune nothing") {
    MidiTuning tuning;
    CHECK(tuning.read(message({{0x7f, 0, 8, 2, 0, 1}, {60, 61, 0, 0}})));
    const auto before = tuning.keys();
    for (const auto& other : {Message{}, message({{0x7e, 0, 8}}), message({{0x7e, 0, 8, 0, 0}}),
                              message({{0x7e, 0, 9, 1}}), message({{0x41, 0, 8, 2, 0, 1}})}) {
        CHECK_FALSE(MidiTuning::isFor(other));
        CHECK_FALSE(tuning.read(other));
    }
    CHECK(tuning.read(message({{0x7f, 0, 8, 2, 0, 1}, {72, 61}})));
    CHECK(tuning.read(message({{0x7f, 0, 8, 2, 0, 1}, {72, 61, 200, 0}})));
    CHECK(tuning.keys() == before);
    tuning.reset();
    CHECK(tuning.keys() == KeyTuning{});
}
