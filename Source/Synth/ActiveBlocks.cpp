// SPDX-License-Identifier: Apache-2.0
#include "Synth/ActiveBlocks.h"

#include <algorithm>
#include <cmath>

namespace idiophone {

ActiveBlocks::ActiveBlocks(ModalBank& ownBank, const BankOutput& ownOutput)
    : bank(ownBank), output(ownOutput), blocks(ownBank.blockCount()) {
    active.reserve(blocks.size());
}

float ActiveBlocks::amplitude(std::size_t g, std::int64_t grid) const noexcept {
    const double held = std::sqrt(static_cast<double>(bank.energies()[g]));
    const Block& block = blocks[g / modeBlock];
    if (block.isActive || held == 0)
        return static_cast<float>(held);
    const double seconds = output.cellSeconds() * static_cast<double>(grid - block.restsSince);
    return static_cast<float>(held * std::exp(block.restsAtDampingLog - output.dampingLog(grid) -
                                              decayBound(bank.pole(g)) * seconds));
}

void ActiveBlocks::activate(std::size_t block) noexcept {
    if (blocks[block].isActive)
        return;
    blocks[block].isActive = true;
    const auto number = static_cast<std::int32_t>(block);
    active.insert(std::ranges::lower_bound(active, number), number);
}

bool ActiveBlocks::wake(float threshold, std::int64_t grid) noexcept {
    const std::size_t before = active.size();
    const auto isLoud = [&](std::size_t b) { return bank.energyOfLoudest(b) > threshold; };
    for (std::size_t b = 0; b < bank.blockCount(); ++b) {
        if (contains(b) || !isLoud(b))
            continue;
        bringUpToDate(b, grid);
        if (isLoud(b))
            activate(b);
    }
    return active.size() > before;
}

void ActiveBlocks::bringUpToDate(std::size_t block, std::int64_t grid) noexcept {
    const Block& resting = blocks[block];
    if (bank.energyOfLoudest(block) > 0)
        bank.advanceBlock(block,
                          output.cellSeconds() * static_cast<double>(grid - resting.restsSince),
                          std::exp(resting.restsAtDampingLog - output.dampingLog(grid)));
    rest(block, grid);
}

void ActiveBlocks::bringRestingUpToDate(std::int64_t grid) noexcept {
    for (std::size_t b = 0; b < bank.blockCount(); ++b)
        if (!contains(b))
            bringUpToDate(b, grid);
}

void ActiveBlocks::restAll(std::int64_t grid) noexcept {
    active.clear();
    for (std::size_t b = 0; b < blocks.size(); ++b)
        rest(b, grid);
}

void ActiveBlocks::rest(std::size_t block, std::int64_t grid) noexcept {
    blocks[block] = {.restsSince = grid, .restsAtDampingLog = output.dampingLog(grid)};
}

} // namespace idiophone
