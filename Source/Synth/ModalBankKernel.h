// SPDX-License-Identifier: Apache-2.0
// The inner loops of synthesis, with SIMD chosen at run time: they move the states of many modes by
// a cell and add their sound to a buffer. They read and write arrays and keep no state.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

inline constexpr std::size_t subBlockSamples = 16;
inline constexpr std::size_t subBlocks = 4;
inline constexpr std::size_t cellSize = subBlocks * subBlockSamples; ///< equals cellSamples

/// Arrays over modes are padded to whole blocks of this size and aligned to 64 bytes.
inline constexpr std::size_t modeBlock = 16;

/// |s|² that no sensible object reaches; larger values would overflow when squared.
inline constexpr float largestEnergy = 1e36f;

/// Residues [m/s] and forces [N] beyond any real object or strike. Up to these, everything that is
/// added to states and sound is finite.
inline constexpr float largestResidue = 1e17f;
inline constexpr float largestForceNewtons = 1e12f;

/// Smaller table entries become zero. The limit is far below the rounding of a table and, even when
/// multiplied by a faint state, far above denormals.
inline constexpr double faintestTableEntry = 1e-15;

/// States below this limit [m/s], −360 dB of full scale, become zero. It is far above
/// single-precision denormals.
inline constexpr double faintestVelocity = 1e-18;

/// Number of modes whose states are computed before they are mixed; their data stays in the L1
/// cache.
inline constexpr std::size_t batchModes = 128;

/// States of a batch at the start of each sub-block.
struct SubBlockStates {
    alignas(64) float x[subBlocks][batchModes];
    alignas(64) float y[subBlocks][batchModes];
};

/// Rotations of oscillating modes, with ρ = e^{ω⁺/fs}: real and imaginary parts of ρ¹⁶ and ρ⁶⁴.
struct ModeRotations {
    const float* subBlockRe;
    const float* subBlockIm;
    const double* cellRe;
    const double* cellIm;
};

/// Fills `ahead` with the states of `count` modes (whole blocks, at most a batch) at the start of
/// each sub-block. Moves x, y by one cell times `scale` and writes |s|² to `energies`. States are
/// double, so that the phase holds for hours; within a cell single precision suffices.
void advanceModes(const ModeRotations& rotations,
                  std::size_t count,
                  double scale,
                  double* x,
                  double* y,
                  float* energies,
                  SubBlockStates& ahead) noexcept;

/// Fills the first `blocks` sub-blocks of `ahead` from states in single precision; moves nothing.
void fillAhead(const ModeRotations& rotations,
               std::size_t count,
               std::size_t blocks,
               const float* x,
               const float* y,
               SubBlockStates& ahead) noexcept;

/// Adds the sound of a run of `count` modes of a batch to `output` (16 · `blocks` samples). Their
/// tables start at `tables`, their states in `ahead` at place `from`. Sample k of mode g in a
/// sub-block is tables[32 g + k] x + tables[32 g + 16 + k] y.
void mixModes(const float* tables,
              const SubBlockStates& ahead,
              std::size_t from,
              std::size_t count,
              std::size_t blocks,
              float* output) noexcept;

struct EnergySurvey {
    double amplitudes = 0;  ///< Σ |s| over the modes above τ
    std::int32_t modes = 0; ///< number of modes above τ
    bool faint = false;     ///< some state must become zero
};

/// Finds the modes of `blocks` that are above τ. Bit k of masks[b] is set if energies[g] audible[g]
/// > τ² for mode g = 16 b + k.
EnergySurvey surveyEnergies(const float* energies,
                            const float* audible,
                            float tauSquared,
                            float faintSquared,
                            std::span<const std::int32_t> blocks,
                            std::uint16_t* masks) noexcept;

} // namespace idiophone
