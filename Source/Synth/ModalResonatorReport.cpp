// The report of a resonator's groups for display.
#include "Synth/ModalResonator.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

void ModalResonator::report(SoundingGroups& groups) const noexcept {
    groups.law = law;
    groups.thicknessRatio = thicknessRatio;
    groups.tauPascals = tauPascals;
    groups.compression = compression;
    groups.groupsAreBehind = polesBehind;
    groups.count = 0;
    groups.starts[0] = 0;
    for (std::size_t g = 0; g < bank.size(); ++g) {
        const std::int32_t end = groupStarts[g + 1];
        if (static_cast<std::size_t>(end) > groups.amplitudes.size())
            break;
        groups.starts[g + 1] = end;
        groups.amplitudes[g] = amplitudeNow(g);
        groups.standings[g] = standing(g);
        groups.count = g + 1;
    }
}

GroupStanding ModalResonator::standing(std::size_t g) const noexcept {
    const Block& block = blocks[g / modeBlock];
    if (isSet(block.mixed, g))
        return GroupStanding::sounding;
    if (!inBand(g))
        return GroupStanding::outOfBand;
    if (silenced(g))
        return GroupStanding::silenced;
    return isSet(block.rings, g) ? GroupStanding::beyondBudget : GroupStanding::belowTau;
}

/// Returns the current amplitude; a resting block has decayed since it came to rest.
float ModalResonator::amplitudeNow(std::size_t g) const noexcept {
    const double held = std::sqrt(static_cast<double>(bank.energies()[g]));
    const Block& block = blocks[g / modeBlock];
    if (block.active || held == 0)
        return static_cast<float>(held);
    const double seconds = cellSeconds * static_cast<double>(cellIndex - block.restsSince);
    return static_cast<float>(held * std::exp(block.restsAtDampingLog - dampingLog(cellIndex) -
                                              decayBound(bank.pole(g)) * seconds));
}

} // namespace idiophone
