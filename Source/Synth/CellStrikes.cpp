// SPDX-License-Identifier: Apache-2.0
#include "Synth/CellStrikes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

namespace idiophone {

void CellStrikes::schedule(std::size_t slot,
                           const Strike& strike,
                           std::int64_t cell,
                           double sample) {
    const double cells = std::floor(sample / cellSamples);
    pending.push_back({.cell = cell + static_cast<std::int64_t>(cells),
                       .sampleInCell = sample - cells * cellSamples,
                       .number = added++,
                       .slot = slot,
                       .strike = strike});
    std::ranges::push_heap(pending, isLater);
}

bool CellStrikes::isLater(const PendingStrike& one, const PendingStrike& other) {
    return std::tie(one.cell, one.sampleInCell, one.number) >
           std::tie(other.cell, other.sampleInCell, other.number);
}

std::size_t CellStrikes::strikeBefore(double sampleInCell, const BegunCell& cell) {
    const auto isDue = [&](const PendingStrike& next) {
        return next.cell < cell.index ||
               (next.cell == cell.index && next.sampleInCell < sampleInCell);
    };
    std::size_t refused = 0;
    while (!pending.empty() && isDue(pending.front())) {
        std::ranges::pop_heap(pending, isLater);
        const auto due = pending.back();
        pending.pop_back();
        const double sample = due.cell < cell.index ? 0 : due.sampleInCell;
        refused += strike(due.slot, due.strike, sample, cell) ? 0 : 1;
    }
    return refused;
}

bool CellStrikes::strike(std::size_t slot,
                         const Strike& strike,
                         double sample,
                         const BegunCell& cell) {
    const double within = std::clamp(sample, 0.0, std::nextafter(double{cellSamples}, 0.0));
    auto& synthesiser = cell.synthesiser;
    const auto& output = cell.cellsOfSlots[slot];
    if (synthesiser.strike(slot, strike, within, output))
        return true;
    // Split only strikes that found no free contact. A strike refused for another reason is
    // invalid, and so are its parts.
    if (!synthesiser.contactsUsedUp(slot) || !(strike.durationSeconds > 0))
        return false;
    auto impulse = strike;
    impulse.durationSeconds = 0;
    constexpr std::array shares{0.25f, 0.5f, 0.25f};
    if (freeSpace() < shares.size())
        return synthesiser.strike(slot, impulse, within, output);
    for (std::size_t k = 0; k < shares.size(); ++k) {
        for (std::size_t axis = 0; axis < 3; ++axis)
            impulse.impulseNewtonSeconds[axis] = shares[k] * strike.impulseNewtonSeconds[axis];
        const double delaySamples =
            0.25 * static_cast<double>(k + 1) * strike.durationSeconds * synthesiser.sampleRateHz();
        schedule(slot, impulse, cell.index, within + delaySamples);
    }
    return true;
}

} // namespace idiophone
