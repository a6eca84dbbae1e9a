// The pitch of each of an instrument's objects: its key's pitch in the tuning, plus the bend of its
// note.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/KeyTuning.h"
#include "Instrument/PitchBend.h"
#include "Synth/Synthesiser.h"

#include <cstddef>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws. The instrument must outlive it.
///
/// An object with a key of its own (bars, scaled) follows the key. An object that keys share
/// (zones) keeps its pitch in any tuning and follows the bend of the last note.
///
/// Bends glide as parameters do (ParameterGlide.h), because wheels send steps. A new note takes its
/// bend at once.
class SlotTuning {
public:
    SlotTuning(const Instrument& instrument, double secondsPerCell);

    void setTuning(const KeyTuning& wanted) noexcept { tuning = wanted; }
    /// Returns false if the key has no object, or the tuning has no pitch for it.
    bool sounds(int note) const noexcept;
    /// Returns how far the tunings put the lowest slot below equal temperament, at least 0.
    double semitonesBelowEqual() const noexcept;
    void noteOn(int note) noexcept;
    /// Shifts a slot from the next `apply` on, at once.
    void shift(std::size_t slot, double semitones) noexcept { slots[slot].shifted = semitones; }
    /// Call once a cell, before it begins.
    void apply(const PitchBend& bend, Synthesiser& synthesiser) noexcept;
    /// Call within a cell, before new notes strike; affects only their slots.
    void applyToPlayed(const PitchBend& bend, Synthesiser& synthesiser) noexcept;
    void reset() noexcept; ///< the next `apply` sets all bends at once

private:
    struct SlotPitch {
        int note = -1;      ///< note that sets its pitch; −1 if none was played
        double tuned = 0;   ///< semitones by the last tuning with a pitch for it
        double bent = 0;    ///< semitones, gliding towards the wheels
        double shifted = 0; ///< semitones
        bool bendsAtOnce = true;
        double semitones = 0; ///< last value sent to the synthesiser
    };

    bool followsKey(const Key& key) const noexcept;
    void apply(std::size_t slot, const PitchBend& bend, Synthesiser& synthesiser) noexcept;

    const Instrument& instrument;
    double glideShare;
    bool keysHaveObjects;
    KeyTuning tuning;
    std::vector<SlotPitch> slots;
};

} // namespace idiophone
