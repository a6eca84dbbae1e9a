// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModeFlags.h"

#include <algorithm>

namespace idiophone {

ModeFlags::ModeFlags(const ModalBank& bank) : blocks(bank.blockCount()) {
    mixedModes.reserve(bank.size());
    mixedRuns.reserve(bank.size());
}

void ModeFlags::list(std::span<const std::int32_t> activeBlocks) noexcept {
    mixedModes.clear();
    for (const std::int32_t number : activeBlocks)
        appendModes(index(number), blocks[index(number)].mixed, mixedModes);
    findRuns(mixedModes, mixedRuns);
    ++changes;
}

void ModeFlags::clear() noexcept {
    std::ranges::fill(blocks, Block{});
    list({});
}

void ModeFlags::handOn(const ModeGroups& groups, SynthesisScratch& scratch) const noexcept {
    std::ranges::fill(scratch.aboveTau, std::uint16_t{0});
    std::ranges::fill(scratch.wanted, std::uint16_t{0});
    for (const ModeShare& taken : groups.shares()) {
        const std::size_t from = index(taken.from);
        const std::size_t to = index(taken.to);
        if (!groups.audible(to))
            continue;
        if (rings(from))
            scratch.aboveTau[to / modeBlock] |= bitOf(to);
        if (isMixed(from))
            scratch.wanted[to / modeBlock] |= bitOf(to);
    }
}

} // namespace idiophone
