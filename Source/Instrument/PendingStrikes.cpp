#include "Instrument/PendingStrikes.h"

#include <algorithm>
#include <tuple>

namespace idiophone {

PendingStrikes::PendingStrikes(std::size_t capacity) {
    strikes.reserve(capacity);
}

void PendingStrikes::add(const PendingStrike& strike) {
    const auto isLater = [](const PendingStrike& a, const PendingStrike& b) {
        return std::tie(a.cell, a.sampleInCell) > std::tie(b.cell, b.sampleInCell);
    };
    strikes.insert(std::lower_bound(strikes.begin(), strikes.end(), strike, isLater), strike);
}

} // namespace idiophone
