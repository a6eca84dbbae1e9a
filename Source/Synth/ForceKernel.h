// SPDX-License-Identifier: Apache-2.0
// The effect of a cell of continuous force on many modes, with SIMD chosen at run time. Counts are
// whole blocks.
#pragma once

#include "Synth/ModeResidues.h"
#include "Synth/ModeStates.h"
#include "Synth/PoleKernel.h"

#include <cstddef>
#include <span>

namespace idiophone {

/// Adds the effect of a force on the states at the end of the cell. For impulses f[k] at sample k
/// this is b Σ_k r ρ^(64 − k) f[k] with b = 1 + iα/ω_d (docs/decisions/0006). The residue r moves
/// from `start` to `end` in steps of a sub-block. If the contact rests, pass the same residues for
/// both. Writes |s|² of the louder channel to `energies`.
void forceModes(const PoleArrays& modes,
                const float* impulses,
                const ModeResidues& start,
                const ModeResidues& end,
                std::size_t count,
                std::size_t channels,
                ModeStates& states,
                AlignedVector<float>& energies) noexcept;

/// Adds the sound of a cell of impulses to `output`. The response moves from start to end in steps
/// of a sub-block.
void convolveForce(std::span<const float, cellSize> impulses,
                   std::span<const float, cellSize> startResponse,
                   std::span<const float, cellSize> endResponse,
                   std::span<float, cellSize> output) noexcept;

/// Computes output = from + fraction (to − from) over whole blocks.
void blendResponses(
    const float* from, const float* to, float fraction, std::size_t count, float* output) noexcept;

/// Returns the position of the middle of sub-block b between start (0) and end (1).
constexpr float fractionAt(std::size_t block) noexcept {
    return (static_cast<float>(block) + 0.5f) / static_cast<float>(subBlocks);
}

} // namespace idiophone
