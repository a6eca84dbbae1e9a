#include "Instrument/SlotTuning.h"

#include <cmath>
#include <cstddef>

namespace idiophone {

SlotTuning::SlotTuning(const Instrument& playedInstrument)
    : instrument(playedInstrument), keysHaveObjects(instrument.keysHaveObjects()),
      slots(instrument.slots().size()) {
    if (keysHaveObjects)
        for (int note = 0; note < KeyTuning::notes; ++note)
            noteOn(note);
}

bool SlotTuning::sounds(int note) const noexcept {
    return instrument.key(note).slot >= 0 &&
           !(keysHaveObjects && tuning.unmapped[static_cast<std::size_t>(note)]);
}

void SlotTuning::noteOn(int note) noexcept {
    if (instrument.stage() && !keysHaveObjects)
        return; // no slot is the note's
    if (const int slot = instrument.key(note).slot; slot >= 0)
        slots[static_cast<std::size_t>(slot)].note = note;
}

void SlotTuning::apply(const PitchBend& bend, Synthesiser& synthesiser) noexcept {
    for (std::size_t slot = 0; slot < slots.size(); ++slot) {
        auto& [note, tuned, semitones] = slots[slot];
        if (note < 0)
            continue;
        if (const auto index = static_cast<std::size_t>(note);
            keysHaveObjects && !tuning.unmapped[index])
            tuned = tuning.semitonesFromEqual[index];
        const double wanted = tuned + bend.ownSemitones(note);
        if (wanted == semitones)
            continue;
        semitones = wanted;
        synthesiser.setFrequencyRatio(slot, std::exp2(wanted / 12));
    }
}

} // namespace idiophone
