#include "Instrument/KeyState.h"
#include "Instrument/MidiControllers.h"
#include "Support/RenderNotes.h"
#include "Synth/SharedSurfaceProfile.h"
#include "TestInstruments.h"

#include <catch2/catch_test_macros.hpp>
#include <vector>

using namespace idiophone;
using namespace idiophone::test;

namespace {

/// The state of keys. Each call of `follow` gives the events of one sample.
struct Rig {
    void follow(const std::vector<MidiEvent>& events) {
        keys.beginSample(events);
        for (const auto& event : events)
            keys.follow(event);
        keys.endSample(events);
    }

    std::shared_ptr<const Instrument> instrument = bars();
    HeldContacts contacts{*instrument, sharedSurfaceProfile({}, 48000), 1};
    KeyState keys{contacts};
};

MidiEvent noteOn(int note, int channel = 0) {
    return test::midi(0, 0x90 | channel, note, 100);
}

MidiEvent noteOff(int note, int channel = 0) {
    return test::midi(0, 0x80 | channel, note, 0);
}

MidiEvent control(int number, int value, int channel = 0) {
    return test::midi(0, 0xb0 | channel, number, value);
}

} // namespace

TEST_CASE("A key is held while any channel or the sustain pedal holds it") {
    Rig rig;
    rig.follow({noteOn(60), noteOn(60, 3), noteOn(62)});
    rig.follow({noteOff(60)});
    CHECK(rig.keys.heldKeys().test(60));
    rig.follow({noteOff(60, 3)});
    CHECK_FALSE(rig.keys.heldKeys().test(60));
    rig.follow({control(midi::sustainPedal, 127), noteOff(62)});
    CHECK(rig.keys.heldKeys().test(62));
    rig.follow({control(midi::sustainPedal, 0)});
    CHECK(rig.keys.heldKeys().none());
}

TEST_CASE("The sostenuto pedal holds the keys that are down, and no later ones") {
    Rig rig;
    rig.follow({noteOn(60)});
    rig.follow({control(midi::sostenutoPedal, 127)});
    rig.follow({noteOn(62)});
    rig.follow({noteOff(60), noteOff(62)});
    CHECK(rig.keys.heldKeys() == KeyState::Keys().set(60));
    rig.follow({control(midi::sostenutoPedal, 0)});
    CHECK(rig.keys.heldKeys().none());
}

TEST_CASE("A note has the maximum pressure of its keys until they go up") {
    Rig rig;
    rig.follow({noteOn(60), noteOn(60, 1)});
    rig.follow({test::midi(0, 0xa0, 60, 127)});
    rig.follow({test::midi(0, 0xd1, 64, 0)});
    CHECK(rig.keys.pressure(60) == 1);
    rig.follow({noteOff(60)});
    CHECK(rig.keys.pressure(60) == 64 / 127.0f);
    rig.follow({noteOff(60, 1)});
    CHECK(rig.keys.pressure(60) == 0);
    rig.follow({test::midi(0, 0xa0, 60, 127)});
    CHECK(rig.keys.pressure(60) == 0);
}

TEST_CASE("A new key takes its sample's last pressure, but ignores zero pressure before the key") {
    const auto pressureAfter = [](const std::vector<MidiEvent>& events) {
        Rig rig;
        rig.follow(events);
        return rig.keys.pressure(60);
    };
    CHECK(pressureAfter({test::midi(0, 0xd0, 127, 0), noteOn(60)}) == 1);
    CHECK(pressureAfter({test::midi(0, 0xd0, 127, 0), test::midi(0, 0xd0, 0, 0), noteOn(60)}) == 0);
    CHECK(pressureAfter({test::midi(0, 0xd1, 127, 0), noteOn(60)}) == 0);
    CHECK(pressureAfter({test::midi(0, 0xd0, 127, 0), control(midi::allNotesOff, 0), noteOn(60)}) ==
          0);
}

TEST_CASE("The soft pedal halves the mallet's speed when it is fully down") {
    Rig rig;
    CHECK(rig.keys.softness() == 1);
    rig.follow({control(midi::softPedal, 127)});
    CHECK(rig.keys.softness() == 0.5);
    rig.follow({control(midi::resetControllers, 0)});
    CHECK(rig.keys.softness() == 1);
}

TEST_CASE("All Notes Off releases keys held by pedals too, and Reset All Controllers keeps pressed "
          "ones") {
    Rig rig;
    rig.follow({control(midi::sustainPedal, 127), noteOn(60), noteOn(62)});
    rig.follow({noteOff(62), control(midi::modulation, 9)});
    rig.follow({control(midi::resetControllers, 0)});
    CHECK(rig.keys.heldKeys() == KeyState::Keys().set(60));
    CHECK(rig.keys.modulationWheel() == HeldContacts::controllerAtRest);
    rig.follow({control(midi::allNotesOff, 0)});
    CHECK(rig.keys.heldKeys().none());
}

TEST_CASE("A key state takes over another one's pedals and wheels, but not its held keys") {
    Rig former, next;
    former.follow({control(midi::sustainPedal, 127), control(midi::softPedal, 127),
                   control(midi::modulation, 9), test::midi(0, 0xe0, 0, 127), noteOn(60)});
    next.keys.takeControllersOf(former.keys);
    CHECK(next.keys.heldKeys().none());
    CHECK(next.keys.softness() == 0.5);
    CHECK(next.keys.modulationWheel() == 9);
    next.keys.bend().setParameters({});
    former.keys.bend().setParameters({});
    CHECK(next.keys.bend().commonSemitones(-1) == former.keys.bend().commonSemitones(60));
    CHECK(next.keys.bend().commonSemitones(-1) > 1.9);
    next.follow({noteOn(62)});
    next.follow({noteOff(62)});
    CHECK(next.keys.heldKeys().test(62));
}
