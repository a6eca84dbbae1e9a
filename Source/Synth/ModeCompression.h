// SPDX-License-Identifier: Apache-2.0
// Merges modes that the ear cannot tell apart into groups: pure functions of poles, material and
// residues (docs/decisions/0015). They know neither time nor samples.
#pragma once

#include "Synth/ModalPole.h"

#include <complex>
#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

/// Maximum number of modes per group: a strike costs a pass over all pairs within a group.
inline constexpr std::size_t maximumGroup = 32;

/// Returns the just noticeable difference D(f) in Hz: straight lines through (20, 1.5), (2000, 5)
/// and (22000, 300), continued beyond. For a dense spectrum 962 windows cover 20 to 22000 Hz.
double discriminationHz(double frequencyHz) noexcept;

/// Returns whether a bar and its tube share this mode (`gains` empty: no).
inline bool isShared(std::span<const std::complex<float>> gains, std::size_t mode) noexcept {
    return !gains.empty() && gains[mode] != std::complex<float>(1);
}

/// Groups modes in ascending order into contiguous runs and returns the number G of groups. Group g
/// is the modes groupStarts[g] to groupStarts[g+1] − 1 (`groupStarts` has room for M + 1).
///
/// A mode joins the previous mode's group if all of this holds against the group's FIRST mode (a
/// chain of comparisons could merge everything):
///  - its damped frequency differs by at most compression · D;
///  - they do not beat audibly: |Δω| ≤ (α_i + α_j)/2, so they decay within one beat;
///  - both oscillate (over-damped modes have no frequency to compare);
///  - their damping is equal, or its decay is 0.75 to 1.4 times the first's: such decay times sound
///    alike (Järveläinen & Tolonen 2001).
///
/// Modes whose λ agree within 1e-9 and whose damping is equal are one pole. They always join, even
/// at compression 0. Modes of different `kinds` (empty: all alike) never join. Modes with a gain
/// other than 1 (`gains` empty: none) join no group. Bar and tube share such modes in pairs, which
/// cancel at first and then diverge, so that the sound builds up.
std::size_t groupModes(std::span<const double> referenceEigenvalues,
                       const PoleLaw& law,
                       double compression,
                       std::span<std::int32_t> groupStarts,
                       std::span<const ModeDamping> dampings = {},
                       std::span<const std::uint8_t> kinds = {},
                       std::span<const std::complex<float>> gains = {}) noexcept;

/// Returns the reference eigenvalue of a group: the square of the mean of √λ weighted by `weights`
/// (each mode's mean-square shape). It does not depend on the struck point. Exact if the members
/// are equal.
double mergedEigenvalue(std::span<const double> referenceEigenvalues,
                        std::span<const double> weights) noexcept;

/// Returns the damping of a group: the mean weighted by `weights`. Exact if the members are equal.
ModeDamping mergedDamping(std::span<const ModeDamping> dampings,
                          std::span<const double> weights) noexcept;

/// Returns the number of pairs in a group of `modes`.
constexpr std::size_t pairsOf(std::size_t modes) noexcept {
    return modes * (modes - 1) / 2;
}

/// Computes the share that each pair of a group's modes loses because their poles differ:
/// Δ_ij²/(a_ij² + Δ_ij²) for i < j in the order (0,1), (0,2), …, with a_ij = α_i + α_j and Δ_ij =
/// ω_i − ω_j.
void findLostShares(std::span<const double> referenceEigenvalues,
                    const PoleLaw& law,
                    std::span<float> shares,
                    std::span<const ModeDamping> dampings = {}) noexcept;

/// Returns the complex residue of a group: |R|² = Σ_ij Re(r_i r_j*) a_ij²/(a_ij² + Δ_ij²), with the
/// phase of Σr. Equal poles give Σr exactly.
std::complex<float> mergedResidue(std::span<const std::complex<float>> residues,
                                  std::span<const float> lostShares) noexcept;

} // namespace idiophone
