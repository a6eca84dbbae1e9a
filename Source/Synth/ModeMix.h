// SPDX-License-Identifier: Apache-2.0
// Mixes a batch of modes whose states at the start of each sub-block are known.
#pragma once

#include "Synth/ModalBankKernel.h"
#include "Synth/ModeRun.h"

#include <span>

namespace idiophone {

/// Modes `first` to `end` − 1, at most a batch, over the first sub-blocks of a cell.
struct MixBatch {
    const float* tables; ///< of all modes
    std::size_t first, end;
    std::size_t subBlockCount;

    /// Adds the modes of `runs` within the batch.
    void
    mix(std::span<const ModeRun> runs, const SubBlockStates& ahead, float* output) const noexcept;

    /// Adds parts of modes within the batch; scales their states in `ahead`.
    void mix(std::span<const ModePart> parts, SubBlockStates& ahead, float* output) const noexcept;
};

} // namespace idiophone
