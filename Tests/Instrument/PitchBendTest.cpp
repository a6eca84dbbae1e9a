#include "Instrument/PitchBend.h"

#include <array>
#include <catch2/catch_approx.hpp>
#include <catch2/catch_test_macros.hpp>

using namespace idiophone;
using Catch::Approx;

namespace {

constexpr int up = 127, rest = 64;

PitchBend bendWith(bool mpe, double range = 2, double memberRange = 48) {
    ParameterValues values;
    values.set(ParameterId::mpe, mpe ? 1 : 0);
    values.set(ParameterId::bendRange, range);
    values.set(ParameterId::mpeBendRange, memberRange);
    PitchBend bend;
    bend.setParameters(values);
    return bend;
}

void giveRegistered(PitchBend& bend, int channel, int parameter, int value) {
    bend.controller(channel, 101, 0);
    bend.controller(channel, 100, parameter);
    bend.controller(channel, 6, value);
}

} // namespace

TEST_CASE("Without MPE any channel's wheel bends all notes") {
    auto bend = bendWith(false);
    bend.noteOn(5, 60);
    bend.wheel(5, 127, up);
    CHECK(bend.commonSemitones(60) == 2);
    CHECK(bend.ownSemitones(60) == 0);
    bend.wheel(3, 0, 0);
    CHECK(bend.commonSemitones(60) == -2);
    bend.wheel(3, 0, rest);
    CHECK(bend.commonSemitones(60) == 0);
}

TEST_CASE("With MPE a member's wheel bends its own notes, and the zone's wheel bends all of them") {
    auto bend = bendWith(true);
    bend.noteOn(1, 60);
    bend.noteOn(2, 64);
    bend.wheel(1, 127, up);
    CHECK(bend.ownSemitones(60) == 48);
    CHECK(bend.ownSemitones(64) == 0);
    CHECK(bend.commonSemitones(60) == 0);
    bend.wheel(0, 127, up);
    CHECK(bend.commonSemitones(60) == 2);
    CHECK(bend.ownSemitones(64) == 0);
}

TEST_CASE("A note starts at its channel's bend and keeps its bend after its release") {
    auto bend = bendWith(true, 2, 12);
    bend.wheel(4, 127, up);
    bend.noteOn(4, 60);
    CHECK(bend.ownSemitones(60) == 12);
    bend.noteOff(4, 60);
    bend.wheel(4, 0, rest);
    bend.noteOn(4, 62);
    CHECK(bend.ownSemitones(60) == 12);
    CHECK(bend.ownSemitones(62) == 0);
    bend.noteOn(0, 60); // on the zone's own channel
    CHECK(bend.ownSemitones(60) == 0);
}

TEST_CASE("MIDI configures zones regardless of the parameter") {
    auto bend = bendWith(false);
    giveRegistered(bend, 0, 6, 7);
    giveRegistered(bend, 15, 6, 5);
    for (const int channel : {1, 7, 10, 14}) {
        INFO(channel);
        bend.noteOn(channel, 60);
        bend.wheel(channel, 127, up);
        CHECK(bend.ownSemitones(60) == 48);
        CHECK(bend.commonSemitones(60) == 0);
    }
    CHECK(bend.reachOf(0).last == 7);
    CHECK(bend.reachOf(15).first == 10);
    CHECK(bend.reachOf(9).first == 9); // in neither zone
    CHECK(bend.reachOf(9).last == 9);
    giveRegistered(bend, 15, 6, 14); // takes the lower zone's channels
    CHECK(bend.reachOf(0).last == 0);
    CHECK(bend.reachOf(15).first == 1);
    giveRegistered(bend, 15, 6, 0);
    CHECK(bend.reachOf(15).first == 15);
    bend.wheel(1, 127, up);
    CHECK(bend.commonSemitones(60) == 2);
}

TEST_CASE("The wheel of a zone's own channel bends the notes of its zone only") {
    auto bend = bendWith(false);
    giveRegistered(bend, 0, 6, 5);
    giveRegistered(bend, 15, 6, 5);
    constexpr std::array channels{0, 3, 7, 8, 11, 15}; // two of each zone, two outside
    constexpr std::array groups{0, 0, 1, 1, 2, 2};
    constexpr std::array wheels{0, 8, 15}; // one of each group
    for (std::size_t i = 0; i < channels.size(); ++i)
        bend.noteOn(channels[i], 60 + static_cast<int>(i));
    for (std::size_t wheel = 0; wheel < wheels.size(); ++wheel) {
        bend.wheel(wheels[wheel], 127, up);
        for (std::size_t i = 0; i < channels.size(); ++i) {
            CAPTURE(wheel, channels[i]);
            const int note = 60 + static_cast<int>(i);
            CHECK(bend.commonSemitones(note) == (groups[i] == static_cast<int>(wheel) ? 2 : 0));
            bend.noteOff(channels[i], note); // the note keeps its bend while it rings
        }
        bend.controller(wheels[wheel], 121, 0);
    }
    bend.wheel(0, 127, up);
    CHECK(bend.commonSemitones(50) == 2); // not played yet
    bend.noteOn(15, 60);                  // in the other zone now
    CHECK(bend.commonSemitones(60) == 0);
}

TEST_CASE("A zone that ends leaves the other zone its members") {
    auto bend = bendWith(true, 2, 24);
    giveRegistered(bend, 15, 6, 0);
    CHECK(bend.reachOf(0).last == 15);
    bend.noteOn(1, 60);
    bend.wheel(1, 127, up);
    CHECK(bend.ownSemitones(60) == 24);
    giveRegistered(bend, 15, 6, 1);
    CHECK(bend.reachOf(0).last == 13);
}

TEST_CASE("A parameter that follows MIDI leaves the exact given value in effect") {
    auto bend = bendWith(false);
    giveRegistered(bend, 0, 6, 3);
    giveRegistered(bend, 1, 0, 0);  // below its parameter's minimum
    giveRegistered(bend, 0, 0, 60); // above the maximum
    giveRegistered(bend, 0, 0, 7);
    bend.controller(0, 38, 50); // between two steps of its parameter
    const auto given = bend.takeGiven();
    CHECK(given.mpe == 1);
    CHECK(given.memberRange == 0);
    const auto nothing = bend.takeGiven();
    CHECK_FALSE((nothing.mpe || nothing.memberRange));

    bend.noteOn(1, 60);
    bend.wheel(0, 127, up);
    bend.wheel(1, 127, up);
    ParameterValues values;
    values.set(ParameterId::mpe, *given.mpe);
    values.set(ParameterId::mpeBendRange, *given.memberRange);
    REQUIRE(values[ParameterId::mpeBendRange] == 1);
    bend.setParameters(values);
    CHECK(bend.reachOf(0).last == 3);
    CHECK(bend.commonSemitones(60) == 7.5);
    CHECK(bend.ownSemitones(60) == 0);

    // Another source moves the parameters.
    values.set(ParameterId::mpeBendRange, 12);
    values.set(ParameterId::bendRange, 3);
    bend.setParameters(values);
    CHECK(bend.commonSemitones(60) == 3);
    CHECK(bend.ownSemitones(60) == 12);
    giveRegistered(bend, 0, 6, 0);
    CHECK(bend.takeGiven().mpe == 0);
}

TEST_CASE("After forgetGiven zones and ranges are the parameters' again") {
    auto bend = bendWith(true, 3, 24);
    giveRegistered(bend, 0, 6, 7);
    giveRegistered(bend, 15, 6, 7);
    giveRegistered(bend, 0, 0, 12);
    bend.forgetGiven();
    CHECK(bend.reachOf(0).last == 15);
    CHECK_FALSE(bend.takeGiven().mpe);
    bend.noteOn(14, 60);
    bend.wheel(14, 127, up);
    bend.wheel(0, 127, up);
    CHECK(bend.ownSemitones(60) == 24);
    CHECK(bend.commonSemitones(60) == 3);
}

TEST_CASE("A bend range that MIDI gives holds until the parameter moves") {
    auto bend = bendWith(true);
    giveRegistered(bend, 0, 0, 7);
    bend.controller(0, 38, 50);
    bend.wheel(0, 127, up);
    CHECK(bend.commonSemitones(60) == Approx(7.5));
    giveRegistered(bend, 3, 0, 24); // acts on all members
    bend.noteOn(5, 60);
    bend.wheel(5, 127, up);
    CHECK(bend.ownSemitones(60) == 24);

    ParameterValues values;
    values.set(ParameterId::mpe, 1);
    values.set(ParameterId::bendRange, 3);
    bend.setParameters(values);
    CHECK(bend.commonSemitones(60) == 3);
    CHECK(bend.ownSemitones(60) == 24);

    bend.controller(0, 101, 127); // null parameter: data entry has no effect
    bend.controller(0, 100, 127);
    bend.controller(0, 6, 11);
    CHECK(bend.commonSemitones(60) == 3);
}

TEST_CASE("Switching MPE on resets all wheels, and the parameter overrides MIDI") {
    auto bend = bendWith(false);
    bend.wheel(7, 0, 96);
    CHECK(bend.commonSemitones(60) == Approx(1).margin(0.01));
    ParameterValues values;
    values.set(ParameterId::mpe, 1);
    bend.setParameters(values);
    CHECK(bend.commonSemitones(60) == 0);
    CHECK(bend.reachOf(0).last == 15);
    giveRegistered(bend, 0, 6, 0);
    CHECK(bend.reachOf(0).last == 0);
    values.set(ParameterId::mpe, 0);
    bend.setParameters(values);
    values.set(ParameterId::mpe, 1);
    bend.setParameters(values);
    CHECK(bend.reachOf(0).last == 15);
}

TEST_CASE("Data for an unregistered parameter does not change a bend range") {
    auto bend = bendWith(false);
    giveRegistered(bend, 0, 0, 12);
    bend.controller(0, 99, 1);
    bend.controller(0, 98, 8);
    bend.controller(0, 6, 64);
    bend.wheel(0, 127, up);
    CHECK(bend.commonSemitones(60) == 12);
}

TEST_CASE("Notes that all end at once keep their bends") {
    auto bend = bendWith(true);
    bend.noteOn(1, 60);
    bend.wheel(1, 127, up);
    bend.releaseNotes();
    bend.wheel(1, 0, rest);
    CHECK(bend.ownSemitones(60) == 48);
}

TEST_CASE("Reset All Controllers resets a channel's wheel, and a reset keeps zones and ranges") {
    auto bend = bendWith(false);
    giveRegistered(bend, 0, 6, 15);
    giveRegistered(bend, 1, 0, 12);
    bend.noteOn(1, 60);
    bend.wheel(1, 127, up);
    bend.wheel(0, 127, up);
    bend.controller(1, 121, 0);
    CHECK(bend.ownSemitones(60) == 0);
    CHECK(bend.commonSemitones(60) == 2);
    bend.reset();
    CHECK(bend.commonSemitones(60) == 0);
    bend.noteOn(1, 60);
    bend.wheel(1, 127, up);
    CHECK(bend.ownSemitones(60) == 12);
}
