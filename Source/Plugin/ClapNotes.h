// Turns the notes of a CLAP host and their expressions into MIDI, with an MPE channel for each
// note.
#pragma once

#include <array>
#include <clap/events.h>
#include <cstddef>
#include <cstdint>
#include <juce_audio_basics/juce_audio_basics.h>
#include <span>

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
    /// release.
    void follow(const clap_event_header& event, int sampleOffset, const Mpe& mpe);

    /// Returns `others` and all MIDI added since the last call. At equal samples `others` come
    /// first, so that a pedal catches a note that ends with it. Valid until the next call.
    juce::MidiBuffer& takeWith(const juce::MidiBuffer& others);
    /// Forgets all notes and MIDI.
    void reset() noexcept;

private:
    struct Note {
        std::int32_t id = 0;      ///< the host's; -1: none
        std::int16_t channel = 0; ///< the host's, 0 to 15
        std::int16_t key = 0;
        int midiChannel = 0; ///< 0 to 15
        bool ownsChannel = false;
    };

    std::span<Note> held() noexcept { return std::span(notes).first(noteCount); }
    int usersOf(int midiChannel) noexcept;
    int freestMember() noexcept;
    void begin(const clap_event_note& event, const Mpe& mpe);
    void end(const clap_event_note& event, double velocity);
    void express(const clap_event_note_expression& event, const Mpe& mpe);
    void add(int kind, int midiChannel, int first, int second);
    void bend(int midiChannel, double share);

    std::array<Note, 128> notes; ///< the held ones in the order of their starts, then unused ones
    std::size_t noteCount = 0;
    std::array<std::uint64_t, 16> lastUse{}; ///< [MIDI channel] number of the last use; 0: never
    std::uint64_t uses = 0;
    int sample = 0; ///< of the event that is followed
    juce::MidiBuffer added, merged;
};

} // namespace idiophone
