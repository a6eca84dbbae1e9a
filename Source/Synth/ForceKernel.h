// The effect of a cell of continuous force on many modes, with SIMD chosen at run time. Arrays in,
// arrays out; counts are whole blocks.
#pragma once

#include "Synth/ModalBankKernel.h"

#include <cstddef>
#include <span>

namespace idiophone {

/// Arrays over oscillating modes.
struct ForcedModes {
    const float* sampleRe; ///< ρ
    const float* sampleIm;
    const float* subBlockRe; ///< ρ^16
    const float* subBlockIm;
    const double* velocityShare; ///< α/ω_d
};

/// One channel: the states, and complex residues for the point and direction at the cell's start
/// and end.
struct ForcedChannel {
    const float* startRe;
    const float* startIm;
    const float* endRe;
    const float* endIm;
    double* x;
    double* y;
};

/// Adds the effect of a force on the states x, y at the end of the cell. For impulses f[k] at
/// sample k this is b Σ_k r ρ^(64 − k) f[k] with b = 1 + iα/ω_d (docs/decisions/0006). The residue
/// r moves from start to end in steps of a sub-block. If the contact rests, each channel has the
/// same array for both. Writes |s|² of the louder channel to `energies`.
void forceModes(const ForcedModes& modes,
                const float* impulses,
                std::size_t count,
                std::span<const ForcedChannel> channels,
                float* energies) noexcept;

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
