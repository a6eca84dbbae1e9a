#include "Plugin/ClapNotes.h"

#include "Plugin/BareHost.h"
#include "Plugin/ClapHost.h"
#include "Plugin/ClapModulation.h"
#include "Support/AllocationCounter.h"

#include <catch2/catch_approx.hpp>

namespace idiophone {
namespace {

constexpr ClapNotes::Mpe mpe{.isOn = true, .bendRangeSemitones = 48};

struct Rig {
    void follow(const ClapEvent& event) {
        if (const auto key = notes.follow(event.header, 0, mpe))
            modulation.beginNote(*key);
    }
    void modulate(ParameterId target, double amount, int id) {
        modulation.follow(modulationEvent(0, {}, amount, id).modulation, parameters[target], notes);
    }
    double share(ParameterId target, int key) {
        modulation.apply(notes, shifts);
        return shifts.share(target, key);
    }
    /// Returns the numbers of the notes that have ended since the last call.
    std::vector<int> ended() {
        std::vector<int> ids;
        const clap_output_events out{
            &ids, [](const clap_output_events* list, const clap_event_header* event) {
                static_cast<std::vector<int>*>(list->ctx)->push_back(
                    reinterpret_cast<const clap_event_note*>(event)->note_id);
                return true;
            }};
        notes.sendEnds(out, 0);
        return ids;
    }

    test::BareHost host;
    HostParameters parameters{host};
    ClapNotes notes;
    ClapModulation modulation{parameters};
    NoteShifts shifts;
};

ClapEvent noteOff(int key, int id) {
    return noteEvent(CLAP_EVENT_NOTE_OFF, 0, key, id, 0);
}

bool rings(int) {
    return true;
}

bool isSilent(int) {
    return false;
}

} // namespace

TEST_CASE("A CLAP note without a number does not end while its key has another note") {
    Rig rig;
    rig.follow(noteOn(0, 60, -1));
    rig.follow(noteOff(60, -1));
    rig.follow(noteOn(0, 60, -1));
    rig.notes.endSilent(isSilent, 10);
    CHECK(rig.ended().empty());
    rig.follow(noteOff(60, -1));
    rig.notes.endSilent(rings, 10);
    CHECK(rig.ended().empty());
    rig.notes.endSilent(isSilent, 10);
    CHECK(rig.ended() == std::vector{-1});
}

TEST_CASE("The newest CLAP note of a key has the amounts") {
    Rig rig;
    rig.follow(noteOn(0, 60, 1));
    rig.modulate(ParameterId::tune, 0.1, 1);
    CHECK(rig.share(ParameterId::tune, 60) == Catch::Approx(0.1));
    rig.follow(noteOn(0, 60, 2));
    rig.modulate(ParameterId::tune, 0.2, 1);
    CHECK(rig.share(ParameterId::tune, 60) == 0);
    rig.modulate(ParameterId::tune, 0.3, 2);
    CHECK(rig.share(ParameterId::tune, 60) == Catch::Approx(0.3));
    rig.follow(noteOff(60, 1));
    rig.follow(noteOff(60, 2));
    CHECK(rig.share(ParameterId::tune, 60) == Catch::Approx(0.3));
    rig.notes.endSilent(isSilent, 10);
    CHECK(rig.ended().size() == 2);
    CHECK(rig.share(ParameterId::tune, 60) == 0);
}

TEST_CASE("An amount stays within the range of its parameter") {
    Rig rig;
    rig.follow(noteOn(0, 60, 1));
    auto& hardness = rig.parameters[ParameterId::hardness];
    hardness.setExactValue(80); // of -100 to 100
    hardness.setModulation(0.5);
    rig.modulate(ParameterId::hardness, 0.05, 1);
    CHECK(rig.share(ParameterId::hardness, 60) == Catch::Approx(-0.05));
}

TEST_CASE("If a host never ends its CLAP notes, the oldest is released and ends") {
    Rig rig;
    for (int id = 0; id < 256; ++id)
        rig.follow(noteOn(0, id % 128, id));
    rig.follow(noteOff(5, 5));
    CHECK(rig.ended().empty());
    rig.notes.takeWith({});
    rig.follow(noteOn(0, 1, 256));
    CHECK(rig.ended() == std::vector{5});
    rig.follow(noteOn(0, 1, 257));
    CHECK(rig.ended() == std::vector{0});
    int released = -1;
    for (const auto& message : rig.notes.takeWith({}))
        if (message.getMessage().isNoteOff())
            released = message.getMessage().getNoteNumber();
    CHECK(released == 0);
}

TEST_CASE("Crowds of CLAP notes and amounts never allocate") {
    Rig rig;
    const test::AllocationCounter counter;
    for (int block = 0; block < 20; ++block) {
        for (int key = 0; key < 128; ++key) {
            rig.follow(noteOn(0, key, 128 * block + key));
            rig.modulate(ParameterId::malletHardness, 0.1, 128 * block + key);
        }
        rig.modulation.apply(rig.notes, rig.shifts);
        for (int key = 0; key < 128; ++key)
            rig.follow(noteOff(key, 128 * block + key));
        rig.notes.takeWith({});
        rig.notes.endSilent(block % 2 == 0 ? rings : isSilent, 479);
        const clap_output_events out{
            nullptr, [](const clap_output_events*, const clap_event_header*) { return true; }};
        rig.notes.sendEnds(out, 0);
    }
    CHECK(counter.allocations() == 0);
}

} // namespace idiophone
