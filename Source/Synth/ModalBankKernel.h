// The inner loops of synthesis, with SIMD chosen at run time: states of many modes are taken on by
// a cell, and what they sound is added to a buffer. Arrays in, arrays out; nothing is kept.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

inline constexpr std::size_t subBlockSamples = 16;
inline constexpr std::size_t subBlocks = 4;
inline constexpr std::size_t cellSize = subBlocks * subBlockSamples; ///< cellSamples

/// Arrays over modes are padded to whole blocks of this many, aligned to 64 bytes.
inline constexpr std::size_t modeBlock = 16;

/// |s|² that no object that makes sense reaches; beyond, squares would overflow.
inline constexpr float largestEnergy = 1e36f;

/// Residues [m/s] and forces [N] that nothing reaches, however light it is and hard it is struck:
/// up to these all that is added to states and sound is finite.
inline constexpr float largestResidue = 1e17f;
inline constexpr float largestForceNewtons = 1e12f;

/// Smaller entries of tables are zero: far below the rounding of a table, far above denormals even
/// when multiplied by a faint state.
inline constexpr double faintestTableEntry = 1e-15;

/// States below this [m/s], −360 dB of full scale, are zero: far above single-precision denormals.
inline constexpr double faintestVelocity = 1e-18;

/// Modes whose states are computed ahead of mixing them; what they touch stays in the first cache.
inline constexpr std::size_t batchModes = 128;

/// States of a batch at the start of each sub-block.
struct SubBlockStates {
    alignas(64) float x[subBlocks][batchModes];
    alignas(64) float y[subBlocks][batchModes];
};

/// Rotations of oscillating modes: with ρ = e^{ω⁺/fs}, ρ¹⁶ and ρ⁶⁴ as real and imaginary parts.
struct ModeRotations {
    const float* subBlockRe;
    const float* subBlockIm;
    const double* cellRe;
    const double* cellIm;
};

/// Fills `ahead` with the states of `count` modes (whole blocks, at most a batch) at the start of
/// each sub-block, takes x, y on by one cell times `scale`, and writes |s|² there. States are kept
/// in double, so that the phase holds for hours; within a cell, single precision does.
void advanceModes(const ModeRotations& rotations,
                  std::size_t count,
                  double scale,
                  double* x,
                  double* y,
                  float* energies,
                  SubBlockStates& ahead) noexcept;

/// Only fills the first `blocks` sub-blocks of `ahead`, from states in single precision.
void lookAhead(const ModeRotations& rotations,
               std::size_t count,
               std::size_t blocks,
               const float* x,
               const float* y,
               SubBlockStates& ahead) noexcept;

/// Adds to `output` (16 · `blocks` samples) what a run of `count` modes of a batch sounds, whose
/// tables start at `tables` and whose states stand in `ahead` from place `from` on: in sub-block b,
/// sample k of mode g, tables[32 g + k] x + tables[32 g + 16 + k] y.
void mixModes(const float* tables,
              const SubBlockStates& ahead,
              std::size_t from,
              std::size_t count,
              std::size_t blocks,
              float* output) noexcept;

/// What a survey of some blocks found.
struct EnergySurvey {
    double amplitudes = 0;  ///< Σ |s| over the modes above τ
    std::int32_t modes = 0; ///< their number
    bool faint = false;     ///< some state should become zero
};

/// Which modes of `blocks` are above τ: bit k of masks[b] becomes whether energies[g] audible[g] >
/// τ² for mode g = 16 b + k.
EnergySurvey surveyEnergies(const float* energies,
                            const float* audible,
                            float tauSquared,
                            float faintSquared,
                            std::span<const std::int32_t> blocks,
                            std::uint16_t* masks) noexcept;

} // namespace idiophone
