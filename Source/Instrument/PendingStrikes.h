// A queue of pending strikes in order of time, on the grid of cells.
#pragma once

#include "Synth/Strike.h"
#include "Synth/SynthesisSettings.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

struct PendingStrike {
    std::int64_t cell = 0;
    double sampleInCell = 0; ///< 0 ≤ s < 64, may be fractional
    std::size_t slot = 0;
    Strike strike;
};

/// The constructor reserves memory; the rest is for the audio thread.
class PendingStrikes {
public:
    explicit PendingStrikes(std::size_t capacity);

    std::size_t room() const { return strikes.capacity() - strikes.size(); }
    bool empty() const { return strikes.empty(); }
    void clear() { strikes.clear(); }

    /// Adds a strike; needs room() > 0. Strikes at the same time keep the order in which they were
    /// added.
    void add(const PendingStrike& strike);

    /// Returns the next strike, or nullptr. `add`, `pop` and `clear` invalidate it.
    const PendingStrike* next() const { return strikes.empty() ? nullptr : &strikes.back(); }
    void pop() { strikes.pop_back(); }

private:
    std::vector<PendingStrike> strikes; ///< latest first, so that the next is at the back
};

} // namespace idiophone
