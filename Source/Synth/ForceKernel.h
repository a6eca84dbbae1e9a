// What a cell of continuous force does to many modes at once, with SIMD chosen at run time. Arrays
// in, arrays out; counts are whole blocks.
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

/// One channel: complex residues for the point and direction at the start and at the end of the
/// cell, and states.
struct ForcedChannel {
    const float* startRe;
    const float* startIm;
    const float* endRe;
    const float* endIm;
    double* x;
    double* y;
};

/// Adds to the states x, y at the end of the cell what a force did to them: for impulses f[k] at
/// sample k, b Σ_k r ρ^(64 − k) f[k] with b = 1 + iα/ω_d (docs/decisions/0006). The
/// residue r goes from start to end in steps of a sub-block; a contact that stays gives the same
/// array for both, in each channel. `energies` become the states' |s|² in the louder channel.
void forceModes(const ForcedModes& modes,
                const float* impulses,
                std::size_t count,
                std::span<const ForcedChannel> channels,
                float* energies) noexcept;

/// Adds to `output` what impulses sound through responses that go from start to end in steps of a
/// sub-block; all of a cell.
void convolveForce(std::span<const float, cellSize> impulses,
                   std::span<const float, cellSize> startResponse,
                   std::span<const float, cellSize> endResponse,
                   std::span<float, cellSize> output) noexcept;

/// output = from + way (to − from), over whole blocks.
void blendResponses(
    const float* from, const float* to, float way, std::size_t count, float* output) noexcept;

/// How far on the way from start to end the middle of sub-block b is.
constexpr float shareOfWay(std::size_t block) noexcept {
    return (static_cast<float>(block) + 0.5f) / static_cast<float>(subBlocks);
}

} // namespace idiophone
