// SPDX-License-Identifier: Apache-2.0
// Places strikes at their samples in a synthesiser's cells. Later strikes wait. A strike that finds
// an object's contacts in use becomes impulses, so none is lost.
#pragma once

#include "Synth/CellOutput.h"
#include "Synth/Strike.h"
#include "Synth/Synthesiser.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// The newest cell that a synthesiser has begun, and the output of each of its slots.
struct BegunCell {
    Synthesiser& synthesiser;
    std::span<const CellOutput> cellsOfSlots;
    std::int64_t index = 0;
};

/// The constructor reserves memory. The rest is for the audio thread and neither allocates, locks
/// nor throws.
class CellStrikes {
public:
    explicit CellStrikes(std::size_t capacity) { pending.reserve(capacity); }

    std::size_t freeSpace() const { return pending.capacity() - pending.size(); }
    bool empty() const { return pending.empty(); }
    void clear() { pending.clear(); }

    /// Adds a pending strike; needs freeSpace() > 0. `sample` ≥ 0 counts from the start of cell
    /// `cell`, and may lie beyond its end. Strikes at the same time keep the order in which they
    /// were added.
    void schedule(std::size_t slot, const Strike& strike, std::int64_t cell, double sample);

    /// Plays, in order of time, the pending strikes before this sample of the cell. Overdue strikes
    /// of earlier cells play at the start of the cell. Returns how many were not valid.
    std::size_t strikeBefore(double sampleInCell, const BegunCell& cell);

    /// Strikes an existing slot at a sample of the cell, clamped to the cell.
    /// An object has a limited number of simultaneous contacts; impulses are not limited. A pulse
    /// beyond the limit becomes three impulses, its values at 1/4, 1/2 and 3/4 of its time. Their
    /// spectrum equals the pulse's up to 2/T and is too bright above. If too many strikes are
    /// pending, the pulse becomes one impulse.
    /// Returns false and does nothing if the strike is not valid for the object.
    bool strike(std::size_t slot, const Strike& strike, double sample, const BegunCell& cell);

private:
    struct PendingStrike {
        std::int64_t cell = 0;
        double sampleInCell = 0;  ///< 0 ≤ s < 64, may be fractional
        std::uint64_t number = 0; ///< of all that were ever added
        std::size_t slot = 0;
        Strike strike;
    };

    static bool isLater(const PendingStrike& one, const PendingStrike& other);

    std::vector<PendingStrike> pending; ///< a heap with the next one in front
    std::uint64_t added = 0;
};

} // namespace idiophone
