// Strikes that are decided and still to come, in order of time, on the grid of cells.
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

/// Memory is reserved by the constructor; the rest is for the audio thread.
class PendingStrikes {
public:
    explicit PendingStrikes(std::size_t capacity);

    std::size_t room() const { return strikes.capacity() - strikes.size(); }
    bool empty() const { return strikes.empty(); }
    void clear() { strikes.clear(); }

    /// Needs room. Of strikes at one time the one that came first is next.
    void add(const PendingStrike& strike);

    /// The next one, if there is one; `add`, `pop` and `clear` end its life.
    const PendingStrike* next() const { return strikes.empty() ? nullptr : &strikes.back(); }
    void pop() { strikes.pop_back(); }

private:
    std::vector<PendingStrike> strikes; ///< the next one last
};

} // namespace idiophone
