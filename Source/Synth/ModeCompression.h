// Which modes of an object the ear cannot tell apart, and what stands for them: pure functions of
// poles, material and residues (docs/decisions/0015). Knows nothing of time or samples.
#pragma once

#include "Synth/ModalPole.h"

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

/// A strike costs a pass over all pairs within a group, so groups are bounded.
inline constexpr std::size_t largestGroup = 32;

/// The just noticeable difference D(f) in Hz: straight lines through (20, 1.5), (2000, 5) and
/// (22000, 300), continued beyond. At a dense spectrum 962 windows cover 20 to 22000 Hz.
double discriminationHz(double frequencyHz) noexcept;

/// Whether a bar and its tube share this mode (`gains` empty: none).
inline bool isShared(std::span<const std::complex<float>> gains, std::size_t mode) noexcept {
    return !gains.empty() && gains[mode] != std::complex<float>(1);
}

/// Groups modes in ascending order into contiguous runs and returns the number G of groups; group g
/// is the modes groupStarts[g] to groupStarts[g+1] − 1 (`groupStarts` has room for M + 1).
/// A mode joins the group of the last one where all of this holds against the group's FIRST mode:
///  - its damped frequency is within compression · D of the first's (a chain would merge
///  everything);
///  - they do not beat audibly: |Δω| ≤ (α_i + α_j)/2, so that they decay within a beat;
///  - both oscillate (over-damped modes have no frequency to compare);
///  - their dampings agree, or its decay over the first's is 0.75 to 1.4: decay times that far
///  apart sound alike (Järveläinen & Tolonen 2001).
/// Modes whose λ agree within 1e-9, and whose dampings are equal, are one pole and always join,
/// even at compression 0. Modes of different `kinds` (empty: all alike) never meet. Nor does a mode
/// with a gain other than 1 meet any (`gains` empty: none has one): bar and tube share such modes
/// in pairs, which cancel at first and grow apart into the bloom.
std::size_t groupModes(std::span<const double> referenceEigenvalues,
                       const PoleLaw& law,
                       double compression,
                       std::span<std::int32_t> groupStarts,
                       std::span<const ModeDamping> dampings = {},
                       std::span<const std::uint8_t> kinds = {},
                       std::span<const std::complex<float>> gains = {}) noexcept;

/// The reference eigenvalue that stands for a group: the square of the mean of √λ weighted by
/// `weights` (each mode's mean-square shape), independent of where the object is struck. Exact
/// where the members are equal.
double mergedEigenvalue(std::span<const double> referenceEigenvalues,
                        std::span<const double> weights) noexcept;

/// The damping that stands for a group: the mean weighted by `weights`. Exact where the members are
/// equal.
ModeDamping mergedDamping(std::span<const ModeDamping> dampings,
                          std::span<const double> weights) noexcept;

/// How many pairs a group of `modes` has.
constexpr std::size_t pairsOf(std::size_t modes) noexcept {
    return modes * (modes - 1) / 2;
}

/// What a group's modes lose of each other because their poles differ: Δ_ij²/(a_ij² + Δ_ij²) of
/// each pair i < j, (0,1), (0,2), …, with a_ij = α_i + α_j and Δ_ij = ω_i − ω_j.
void findLostShares(std::span<const double> referenceEigenvalues,
                    const PoleLaw& law,
                    std::span<float> shares,
                    std::span<const ModeDamping> dampings = {}) noexcept;

/// The complex residue that stands for a group: |R|² = Σ_ij Re(r_i r_j*) a_ij²/(a_ij² + Δ_ij²),
/// with the phase of Σr. Equal poles give Σr exactly.
std::complex<float> mergedResidue(std::span<const std::complex<float>> residues,
                                  std::span<const float> lostShares) noexcept;

} // namespace idiophone
