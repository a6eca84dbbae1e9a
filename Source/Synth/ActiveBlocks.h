// SPDX-License-Identifier: Apache-2.0
// The blocks of a bank that move cell by cell. The other blocks rest: their states stay as they are
// until something needs them, and then follow in closed form.
#pragma once

#include "Synth/BankOutput.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread. `grid` is the
/// grid point where the states of active blocks hold. At first all blocks rest.
class ActiveBlocks {
public:
    /// The arguments outlive this.
    ActiveBlocks(ModalBank& bank, const BankOutput& output);

    bool none() const noexcept { return active.empty(); }
    std::span<const std::int32_t> list() const noexcept { return active; } ///< ascending
    bool contains(std::size_t block) const noexcept { return blocks[block].isActive; }
    /// Returns the current amplitude of a mode; a resting block has decayed since it came to rest.
    float amplitude(std::size_t g, std::int64_t grid) const noexcept;

    /// The states of the block must hold at the grid point already.
    void activate(std::size_t block) noexcept;
    /// Activates all blocks that hold an energy above `threshold`. Returns whether there were any.
    bool wake(float threshold, std::int64_t grid) noexcept;
    /// Moves the states of a resting block to the grid point.
    void bringUpToDate(std::size_t block, std::int64_t grid) noexcept;
    void bringRestingUpToDate(std::int64_t grid) noexcept;

    /// Lets the active blocks rest for which `isDone(block)`.
    template <class Condition>
    void retire(Condition isDone, std::int64_t grid) noexcept {
        std::erase_if(active, [&](std::int32_t number) {
            const bool done = isDone(index(number));
            if (done)
                rest(index(number), grid);
            return done;
        });
    }
    void restAll(std::int64_t grid) noexcept;

private:
    struct Block {
        bool isActive = false;
        std::int64_t restsSince = 0; ///< grid point where the states of a resting block hold
        double restsAtDampingLog = 0;
    };

    void rest(std::size_t block, std::int64_t grid) noexcept;

    ModalBank& bank;
    const BankOutput& output;
    std::vector<Block> blocks;
    std::vector<std::int32_t> active; ///< ascending
};

} // namespace idiophone
