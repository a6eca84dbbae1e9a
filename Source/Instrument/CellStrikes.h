// Strikes at their samples of a synthesiser's cells, none of which is lost: what is to come waits,
// and what finds no room among an object's contacts comes as impulses instead.
#pragma once

#include "Instrument/PendingStrikes.h"
#include "Synth/CellOutput.h"
#include "Synth/Synthesiser.h"

#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

/// The cell that a synthesiser has begun last, and where each of its slots sounds.
struct BegunCell {
    Synthesiser& synthesiser;
    std::span<const CellOutput> cellsOfSlots;
    std::int64_t index = 0;
};

/// Memory is reserved by the constructor; the rest is for the audio thread and neither allocates,
/// locks nor throws.
class CellStrikes {
public:
    explicit CellStrikes(std::size_t capacity) : pending(capacity) {}

    std::size_t room() const { return pending.room(); }
    bool empty() const { return pending.empty(); }
    void clear() { pending.clear(); }

    /// Needs room. `sample` ≥ 0 counts from the start of cell `cell`, and may be beyond its end.
    void schedule(std::size_t slot, const Strike& strike, std::int64_t cell, double sample);

    /// Strikes in order of time what waits for a sample of the cell before this one; what should
    /// have been in a cell before it comes at once.
    void strikeBefore(double sampleInCell, const BegunCell& cell);

    /// Strikes a slot that exists at a sample of the cell; before and beyond it, at its first or
    /// last moment. An object has room for so many contacts at a time; a pulse beyond comes as
    /// ideal impulses, which need no room: as its values at a quarter, the half and three quarters
    /// of its time, which have its spectrum up to 2/T and are too bright above, or as one where too
    /// many wait. False, and nothing done, where the strike is not valid for the object.
    bool strike(std::size_t slot, const Strike& strike, double sample, const BegunCell& cell);

private:
    PendingStrikes pending;
};

} // namespace idiophone
