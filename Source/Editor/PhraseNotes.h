// Composes the short phrase that shows what an instrument sounds like.
#pragma once

#include "Editor/InstrumentView.h"

#include <vector>

namespace idiophone {

struct PhraseNote {
    int startMilliseconds = 0;
    int endMilliseconds = 0; ///< of the key
    int note = 0;            ///< MIDI
    int velocity = 0;        ///< 1 to 127

    bool operator==(const PhraseNote&) const = default;
};

/// Returns about two seconds around the middle of the instrument's own keys: a rising broken chord
/// if they are tuned, three single keys if one object lies along them all, one note on a stage.
/// Ordered by start; empty if no key sounds.
std::vector<PhraseNote> phraseNotes(const InstrumentView& instrument, bool isStage);

} // namespace idiophone
