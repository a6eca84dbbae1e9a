// Brings modulation to what each slot has for itself: its pitch and its release time.
#pragma once

#include "Instrument/Dampers.h"
#include "Instrument/Modulation.h"
#include "Instrument/SlotTuning.h"

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

namespace idiophone {

/// Constructed off the audio thread; the rest is for the audio thread and neither allocates, locks
/// nor throws.
class SlotModulation {
public:
    explicit SlotModulation(std::size_t slots) : notes(slots, Modulation::hand) {}

    /// Sets which note, or Modulation::hand, plays the slot now.
    void play(std::size_t slot, int note) noexcept { notes[slot] = note; }
    /// Returns whether a slot that the note plays rings.
    bool sounds(int note, const Synthesiser& synthesiser) const noexcept {
        for (std::size_t slot = 0; slot < notes.size(); ++slot)
            if (notes[slot] == note && !synthesiser.silent(slot))
                return true;
        return false;
    }
    /// Gives each slot the values of its own note. Call it before tuning and dampers are applied.
    void apply(const Modulation& modulation, SlotTuning& tuning, Dampers& dampers) noexcept {
        using enum ParameterId;
        const bool tunes = modulation.moves(tune), releases = modulation.moves(releaseTime);
        if (!std::exchange(isActive, tunes || releases) && !isActive)
            return;
        for (std::size_t slot = 0; slot < notes.size(); ++slot) {
            const int note = notes[slot];
            tuning.shift(slot, modulation.shiftOf(tune, note) / 100);
            dampers.setReleaseTime(slot, releases
                                             ? std::optional(modulation.valueOf(releaseTime, note))
                                             : std::nullopt);
        }
    }

private:
    std::vector<int> notes; ///< [slots]
    bool isActive = false;
};

} // namespace idiophone
