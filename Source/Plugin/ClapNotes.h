// Turns the notes of a CLAP host and their expressions into MIDI, with an MPE channel for each
// note, and tells the host when they end.
#pragma once

#include <array>
#include <clap/events.h>
#include <cstddef>
#include <cstdint>
#include <juce_audio_basics/juce_audio_basics.h>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace idiophone {

/// For the audio thread; neither locks nor throws, and allocates only beyond thousands of events a
/// block. Pressure acts on its note alone. While MPE is on, tuning and brightness do too; else they
/// are ignored. Other expressions have no counterpart in the engine.
class ClapNotes {
public:
    struct Mpe {
        bool isOn = false;
        double bendRangeSemitones = 0; ///< of a note's own channel; limits the tuning
    };

    ClapNotes();

    /// Returns whether `follow` handles events of this type of CLAP's own name space.
    static bool handles(std::uint16_t type) noexcept;
    /// Adds the event's MIDI at the sample `event.time - sampleOffset`. A choke is the fastest
    /// release. Returns the key of a note that begins.
    std::optional<int> follow(const clap_event_header& event, int sampleOffset, const Mpe& mpe);

    /// Returns `others` and all MIDI added since the last call. At equal samples `others` come
    /// first, so that a pedal catches a note that ends with it. Valid until the next call.
    juce::MidiBuffer& takeWith(const juce::MidiBuffer& others);
    /// Ends the released notes whose keys are silent, at this sample; `sounds(key)` says which.
    /// Those whose keys have been struck again have ended already.
    template <class Sounds>
    void endSilent(Sounds sounds, int atSample) {
        endReleased([&](const Note& note) { return !sounds(int{note.key}); }, atSample);
    }
    /// Sends all ends since the last call. Their samples move by `sampleOffset`.
    void sendEnds(const clap_output_events& events, int sampleOffset);

    /// Returns whether a note of the key is held or rings.
    bool has(int key) const noexcept;
    /// Calls `act(key)` for each key whose newest note the event addresses.
    template <class Event, class Act>
    void forAddressed(const Event& event, Act act) const {
        for (std::size_t i = 0; i < noteCount; ++i)
            if (isAddressed(notes[i], event) && isNewest(i))
                act(int{notes[i].key});
    }

    /// Forgets all notes and MIDI.
    void reset() noexcept;

private:
    struct Note {
        std::int32_t id = 0;      ///< the host's; -1: none
        std::int16_t channel = 0; ///< the host's, 0 to 15
        std::int16_t key = 0;
        int midiChannel = 0; ///< 0 to 15
        bool ownsChannel = false;
        bool isHeld = true;
    };

    /// A host may leave any of these open with -1.
    template <class Event>
    static bool isAddressed(const Note& note, const Event& event) noexcept {
        return (event.note_id < 0 || event.note_id == note.id) &&
               (event.channel < 0 || event.channel == note.channel) &&
               (event.key < 0 || event.key == note.key);
    }

    /// Those that are held, or ring.
    std::span<Note> known() noexcept { return std::span(notes).first(noteCount); }
    std::span<const Note> known() const noexcept { return std::span(notes).first(noteCount); }
    bool isNewest(std::size_t index) const noexcept;

    template <class IsOver>
    void endReleased(IsOver isOver, int atSample) {
        for (std::size_t i = noteCount; i-- > 0;)
            if (!notes[i].isHeld && isOver(std::as_const(notes[i])))
                forget(i, atSample);
    }
    void forget(std::size_t index, int atSample);
    void makeRoom();
    int usersOf(int midiChannel) noexcept;
    int freestMember() noexcept;
    std::optional<int> begin(const clap_event_note& event, const Mpe& mpe);
    void end(const clap_event_note& event, double velocity);
    void release(Note& note, double velocity);
    void express(const clap_event_note_expression& event, const Mpe& mpe);
    void add(int kind, int midiChannel, int first, int second);
    void bend(int midiChannel, double share);

    std::array<Note, 256> notes; ///< those known in the order of their starts, then unused ones
    std::size_t noteCount = 0;
    std::array<std::uint64_t, 16> lastUse{}; ///< [MIDI channel] number of the last use; 0: never
    std::uint64_t uses = 0;
    int sample = 0; ///< of the event that is followed
    juce::MidiBuffer added, merged;
    std::vector<clap_event_note> ends; ///< not yet sent
};

} // namespace idiophone
