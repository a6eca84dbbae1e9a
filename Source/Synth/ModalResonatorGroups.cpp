// Groups of merged modes that follow the poles while they sound (docs/decisions/0015).
#include "Synth/ModalResonator.h"
#include "Synth/ModeCompression.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace idiophone {

namespace {

// Minimum share of a mode that is worth a fade: far below listening, far above the rounding error
// of sums of shares.
constexpr float smallestFade = 1e-6f;
constexpr float smallestTubeShare = 1e-3f; // a smaller pulsation is inaudible

double sum(std::span<const double> weights) noexcept {
    double total = 0;
    for (const double weight : weights)
        total += weight;
    return total;
}

} // namespace

/// Changes the groups to those of `scratch.groupStarts` and keeps their sound. Each mode takes a
/// fixed share of its group's state along, and modes that join a group add up, so that no velocity
/// steps. Call `bank.movePoles` next.
void ModalResonator::regroup(std::size_t groups) noexcept {
    shareGroups(groups);
    nameGroups(groups);
    handOnFlags();
    fadeChanges();
    bank.regroup(groups, scratch.groupShares, scratch.states);
    findTubeParts();
    rebuildBlocks();
}

/// Divides a group's state among its modes by their mean-square shapes, as if the object had been
/// struck everywhere. The struck points are not stored.
void ModalResonator::shareGroups(std::size_t groups) noexcept {
    scratch.groupShares.clear();
    const std::span<const double> weights(*modeWeights);
    const auto& newStarts = scratch.groupStarts;
    for (std::size_t from = 0, to = 0; from < bank.size() && to < groups;) {
        const auto start = static_cast<std::size_t>(groupStarts[from]);
        const auto end = static_cast<std::size_t>(groupStarts[from + 1]);
        const auto newStart = static_cast<std::size_t>(newStarts[to]);
        const auto newEnd = static_cast<std::size_t>(newStarts[to + 1]);
        const std::size_t first = std::max(start, newStart);
        const std::size_t count = std::min(end, newEnd) - first;
        const double total = sum(weights.subspan(start, end - start));
        const double share = total > 0 ? sum(weights.subspan(first, count)) / total
                                       : static_cast<double>(count) / double(end - start);
        scratch.groupShares.push_back(
            {static_cast<std::int32_t>(from), static_cast<std::int32_t>(to), share});
        from += end <= newEnd ? 1 : 0;
        to += newEnd <= end ? 1 : 0;
    }
}

void ModalResonator::nameGroups(std::size_t groups) noexcept {
    lostSharesLaw.reset();
    std::copy_n(scratch.groupStarts.begin(), groups + 1, groupStarts.begin());
    for (std::size_t g = 0; g < groups; ++g) {
        const auto first = static_cast<std::size_t>(groupStarts[g]);
        const auto count = static_cast<std::size_t>(groupStarts[g + 1]) - first;
        referenceEigenvalues[g] = mergedEigenvalue(std::span(modeEigenvalues).subspan(first, count),
                                                   std::span(*modeWeights).subspan(first, count));
        if (!dampings.empty())
            groupDampings[g] =
                mergedDamping(std::span<const ModeDamping>(dampings).subspan(first, count),
                              std::span<const double>(*modeWeights).subspan(first, count));
    }
}

/// Modes that bar and tube share are separate groups.
void ModalResonator::findTubeParts() noexcept {
    tubeParts.clear();
    for (std::size_t g = 0; !tubeShares.empty() && g < bank.size(); ++g) {
        const float share = tubeShares[static_cast<std::size_t>(groupStarts[g])];
        if (std::abs(share) > smallestTubeShare)
            tubeParts.push_back({static_cast<std::int32_t>(g), share});
    }
}

/// Collects the flags of the new groups in `scratch`, as the fades still need the old ones. A new
/// group rings or is mixed if any old part of it was.
void ModalResonator::handOnFlags() noexcept {
    std::fill(scratch.aboveTau.begin(), scratch.aboveTau.end(), std::uint16_t{0});
    std::fill(scratch.wanted.begin(), scratch.wanted.end(), std::uint16_t{0});
    for (const ModeShare& taken : scratch.groupShares) {
        const auto from = static_cast<std::size_t>(taken.from);
        const auto to = static_cast<std::size_t>(taken.to);
        const Block& block = blocks[from / modeBlock];
        if (!isSet(block.rings | block.mixed, from) || !audible(to))
            continue;
        const auto bit = static_cast<std::uint16_t>(1u << (to % modeBlock));
        if (isSet(block.rings, from))
            scratch.aboveTau[to / modeBlock] |= bit;
        if (isSet(block.mixed, from))
            scratch.wanted[to / modeBlock] |= bit;
    }
}

/// Fades the changes, still with the old poles. Unmixed modes that join a mixed group fade in, and
/// modes that become inaudible fade out.
void ModalResonator::fadeChanges() noexcept {
    auto& fading = scratch.fadingShares;
    for (std::size_t g = 0; g < bank.size(); ++g)
        fading[g] = isSet(blocks[g / modeBlock].mixed, g) ? 1.0f : 0.0f;
    for (const ModeShare& taken : scratch.groupShares) {
        const auto to = static_cast<std::size_t>(taken.to);
        if (isSet(scratch.wanted[to / modeBlock], to))
            fading[static_cast<std::size_t>(taken.from)] -= static_cast<float>(taken.share);
    }
    scratch.leaving.clear();
    for (std::size_t g = 0; g < bank.size(); ++g) {
        if (!(std::abs(fading[g]) > smallestFade && bank.energies()[g] > 0))
            continue;
        fading[scratch.leaving.size()] = fading[g] * openingNow(g);
        scratch.leaving.push_back(static_cast<std::int32_t>(g));
    }
    fader.change(bank, scratch.leaving, fading);
}

void ModalResonator::rebuildBlocks() noexcept {
    activeBlocks.clear();
    for (std::size_t b = 0; b < blocks.size(); ++b) {
        const bool active = (scratch.aboveTau[b] | scratch.wanted[b]) != 0;
        blocks[b] = {.rings = scratch.aboveTau[b],
                     .mixed = scratch.wanted[b],
                     .active = active,
                     .restsSince = cellIndex,
                     .restsAtDampingLog = dampingLog(cellIndex)};
        if (active)
            activeBlocks.push_back(static_cast<std::int32_t>(b));
    }
    mixedIsRinging = false;
    listMixed();
}

} // namespace idiophone
