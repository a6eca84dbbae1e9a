// Eight notes of an instrument, which stand for all its keys where loudness is predicted.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/PhraseMeter.h"
#include "Instrument/SpreadNotes.h"
#include "Synth/AccelerationNoise.h"
#include "Synth/Surface.h"

#include <array>
#include <cstddef>
#include <memory>
#include <utility>

namespace idiophone {

/// Made off the audio thread and immutable.
struct Phrase {
    struct Note {
        Key key;
        RigidRadiator rigidBody;
    };

    /// Spreads the notes over the keys. `surface` must be valid; keys that scrape or roll sound
    /// like it.
    Phrase(std::shared_ptr<const Instrument> played, Surface scraped, double rateHz)
        : Phrase(played,
                 std::move(scraped),
                 rateHz,
                 played->keyMap().lowestNote,
                 played->keyMap().highestNote) {}
    /// Spreads the notes from `lowestNote` to `highestNote`.
    Phrase(std::shared_ptr<const Instrument> played,
           Surface scraped,
           double rateHz,
           int lowestNote,
           int highestNote)
        : instrument(std::move(played)), surface(std::move(scraped)), sampleRateHz(rateHz) {
        for (std::size_t i = 0; i < notes.size(); ++i) {
            auto& [key, rigidBody] = notes[i];
            key = instrument->key(spreadNote(lowestNote, highestNote, static_cast<int>(i),
                                             static_cast<int>(notes.size())));
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
