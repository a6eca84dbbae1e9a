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
        for (std::size_t i = 0; i < notes.size(); ++i) {
            auto& [midiNote, key, rigidBody] = notes[i];
            midiNote = phraseNote(instrument->keyMap(), i);
            key = instrument->key(midiNote);
            if (key.slot >= 0)
                rigidBody =
                    rigidRadiator(*instrument->slots()[static_cast<std::size_t>(key.slot)].object);
        }
    }

    std::shared_ptr<const Instrument> instrument;
    Surface surface;
    double sampleRateHz;
    std::array<Note, PhraseMeter::notes> notes;
};

} // namespace idiophone
