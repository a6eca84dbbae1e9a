// Tests keys held on several MIDI channels.
#include "HeldKeys.h"
#include "Support/Level.h"

#include <array>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using namespace idiophone::test;

TEST_CASE("Messages on one channel leave the held keys of other channels unchanged") {
    const auto instrument = plate();
    const MidiEvent key = midi(0, 0x90, 60, 100);
    const auto still = play(instrument, {key}, 14400);
    const std::array messages{midi(4800, 0xd0, 0, 0),
                              midi(4800, 0xa0, 60, 0),
                              midi(4800, 0x80, 60, 0),
                              midi(4800, 0x90, 60, 0),
                              midi(4800, 0xb0, speedController, 127),
                              midi(4800, 0xb0, placeController, 127),
                              midi(4800, 0xb0, 121, 0)};
    const std::array before{midi(0, 0xb0, speedController, 90), midi(0, 0xb0, placeController, 20),
                            key, midi(0, 0xd0, 20, 0)};
    const auto moved = play(instrument, {before.begin(), before.end()}, 14400);
    for (auto message : messages) {
        std::vector events(before.begin(), before.end());
        events.push_back(message);
        INFO("status " << static_cast<int>(message.bytes[0]) << ", " << +message.bytes[1]);
        CHECK(play(instrument, events, 14400) != moved);
        events.back().bytes[0] |= 5;
        CHECK(play(instrument, events, 14400) == moved);
    }
    for (auto event : before)
        if (event.bytes[0] != key.bytes[0]) {
            event.bytes[0] |= 5;
            CHECK(play(instrument, {event, key}, 14400) == still);
        }
}

TEST_CASE("Two channels hold the same note independently") {
    const auto instrument = plate();
    const auto one = midi(0, 0x91, 60, 100), other = midi(0, 0x92, 60, 100);
    const auto both = play(instrument, {one, other}, 48000);
    const auto afterOne = play(instrument, {one, other, midi(4800, 0x81, 60, 0)}, 48000);
    const auto late = [](const std::vector<float>& sound) {
        return rms(std::span(sound).subspan(38400));
    };
    CHECK(late(both) > 1e-5);
    CHECK(late(afterOne) > 0.5 * late(both));
    CHECK(late(play(instrument, {one, other, midi(4800, 0x81, 60, 0), midi(4800, 0x82, 60, 0)},
                    48000)) < 0.8 * late(afterOne));
}
