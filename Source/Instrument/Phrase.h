// Eight notes of an instrument, which stand for all its keys where loudness is predicted.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/PhraseMeter.h"
#include "Synth/AccelerationNoise.h"
#include "Synth/Surface.h"

#include <array>
#include <cstddef>
#include <memory>
#include <utility>
#include <vector>

namespace idiophone {

/// Returns the MIDI note at `index`, 0 to 7, of a phrase: spread evenly from the map's lowest key
/// to its highest.
inline int phraseNote(const KeyMap& map, std::size_t index) noexcept {
    return map.lowestNote + (map.highestNote - map.lowestNote) * static_cast<int>(index) /
                                static_cast<int>(PhraseMeter::notes - 1);
}

/// Made off the audio thread and immutable.
struct Phrase {
    struct Note {
        int midiNote = 0;
        Key key;
        RigidRadiator rigidBody;
    };

    /// `surface` must be valid; keys that scrape or roll sound like it.
    Phrase(std::shared_ptr<const Instrument> played, Surface scraped, double rateHz)
        : instrument(std::move(played)), surface(std::move(scraped)), sampleRateHz(rateHz) {
        for (std::size_t i = 0; i < notes.size(); ++i)
            notes[i] = noteOf(phraseNote(instrument->keyMap(), i));
    }

    /// Returns the notes between which a value of other keys can be interpolated: in a kit, whose
    /// keys have nothing in common, all that sound.
    std::vector<Note> supports() const {
        if (instrument->keyMap().kind != KeyMapKind::kit)
            return {notes.begin(), notes.end()};
        std::vector<Note> all;
        for (int midiNote = 0; midiNote < 128; ++midiNote)
            if (instrument->key(midiNote).slot >= 0)
                all.push_back(noteOf(midiNote));
        return all;
    }

    std::shared_ptr<const Instrument> instrument;
    Surface surface;
    double sampleRateHz;
    std::array<Note, PhraseMeter::notes> notes;

private:
    Note noteOf(int midiNote) const {
        Note note{.midiNote = midiNote, .key = instrument->key(midiNote), .rigidBody = {}};
        if (const int slot = note.key.slot; slot >= 0)
            note.rigidBody =
                rigidRadiator(*instrument->slots()[static_cast<std::size_t>(slot)].object);
        return note;
    }
};

} // namespace idiophone
