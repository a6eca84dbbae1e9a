// SPDX-License-Identifier: Apache-2.0
// The modes of a bank that ring and those that are mixed, one bit each, and the mixed ones as list
// and runs.
#pragma once

#include "Synth/ModeBits.h"
#include "Synth/ModeGroups.h"
#include "Synth/ModeRun.h"

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread.
class ModeFlags {
public:
    /// The modes of one block, one bit each.
    struct Block {
        std::uint16_t rings = 0;
        std::uint16_t mixed = 0;
    };

    explicit ModeFlags(const ModalBank& bank);

    std::size_t blockCount() const noexcept { return blocks.size(); } ///< at the bank's capacity
    Block& operator[](std::size_t block) noexcept { return blocks[block]; }
    bool isMixed(std::size_t g) const noexcept { return isSet(blocks[g / modeBlock].mixed, g); }
    bool rings(std::size_t g) const noexcept { return isSet(blocks[g / modeBlock].rings, g); }

    // The mixed modes, as of the last `list`.
    std::span<const std::int32_t> mixed() const noexcept { return mixedModes; } ///< ascending
    std::int32_t mixedCount() const noexcept {
        return static_cast<std::int32_t>(mixedModes.size());
    }
    std::span<const ModeRun> runs() const noexcept { return mixedRuns; }
    /// Counts the calls of `list` and `clear`.
    std::uint64_t version() const noexcept { return changes; }

    /// Lists the mixed modes, all of which are in `activeBlocks` (ascending).
    void list(std::span<const std::int32_t> activeBlocks) noexcept;
    void clear() noexcept;

    /// Collects the flags of new groups in the scratch: `aboveTau` and `wanted`. A new group rings
    /// or is mixed if any old part of the group was.
    void handOn(const ModeGroups& groups, SynthesisScratch& scratch) const noexcept;

private:
    std::vector<Block> blocks;
    std::vector<std::int32_t> mixedModes;
    std::vector<ModeRun> mixedRuns;
    std::uint64_t changes = 0;
};

} // namespace idiophone
