// The pitch of each of an instrument's objects: that of its key in the tuning, bent as its note is.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/KeyTuning.h"
#include "Instrument/PitchBend.h"
#include "Synth/Synthesiser.h"

#include <cstddef>
#include <vector>

namespace idiophone {

/// Constructed and destroyed off the audio thread; the rest is for the audio thread and neither
/// allocates, locks nor throws. The instrument outlives it.
///
/// Where keys have objects of their own (bars, scaled) these follow their keys. An object that keys
/// share (zones) keeps its pitch in any tuning, and is bent as the note played last is.
///
/// Bends glide as parameters do (ParameterGlide.h), for wheels send steps; what a note plays is
/// bent at once as that is.
class SlotTuning {
public:
    SlotTuning(const Instrument& instrument, double secondsPerCell);

    void setTuning(const KeyTuning& wanted) noexcept { tuning = wanted; }
    /// False where the tuning has no pitch for the key's object, and where there is none.
    bool sounds(int note) const noexcept;
    /// By how much the lowest slot lies below equal temperament by tunings so far, or 0.
    double semitonesBelowEqual() const noexcept;
    void noteOn(int note) noexcept;
    /// Once a cell, before it begins.
    void apply(const PitchBend& bend, Synthesiser& synthesiser) noexcept;
    /// Within a cell, before what is played strikes: of that alone.
    void applyToPlayed(const PitchBend& bend, Synthesiser& synthesiser) noexcept;
    void reset() noexcept; ///< at the next `apply` all bends are as they should be

private:
    struct SlotPitch {
        int note = -1;    ///< whose pitch it has, or −1: none was played
        double tuned = 0; ///< by the tuning that last had a pitch for it
        double bent = 0;  ///< on the way to where wheels are
        bool bendsAtOnce = true;
        double semitones = 0; ///< as the synthesiser has it
    };

    void apply(std::size_t slot, const PitchBend& bend, Synthesiser& synthesiser) noexcept;

    const Instrument& instrument;
    double glideShare;
    bool keysHaveObjects;
    KeyTuning tuning;
    std::vector<SlotPitch> slots;
};

} // namespace idiophone
