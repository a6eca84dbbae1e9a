// SPDX-License-Identifier: Apache-2.0
// Computes state increments of oscillating modes and moves their states, with SIMD chosen at run
// time. Counts are whole blocks.
#pragma once

#include "Synth/ModeStates.h"
#include "Synth/PoleKernel.h"
#include "Synth/StateIncrements.h"
#include "Synth/UnitContact.h"

namespace idiophone {

/// Sets the increments to the residues times the unit's states, which hold at a time between two
/// samples and are moved to the next one, and `energies` to their |s|² in the louder channel. Modes
/// above the band, which are inaudible, get another phase.
void startIncrements(const PoleArrays& poles,
                     const UnitContact& unit,
                     const BeforeSample& before,
                     const ModeResidues& residues,
                     std::size_t count,
                     std::size_t channels,
                     StateIncrements& increments) noexcept;

/// Adds `factor` times the residues times the unit's forced states. Adds `force` times the
/// imaginary part of each residue, which is heard at once. `force` is the force over Ω, for a unit
/// impulse.
void gatherIncrements(const UnitContact& unit,
                      const ModeResidues& residues,
                      double factor,
                      double force,
                      std::size_t count,
                      std::size_t channels,
                      StateIncrements& increments) noexcept;

/// Sets the increments to those of a whole contact: the increment at its end minus the remainder of
/// the increment at its start. For contacts much shorter than a period this difference is small,
/// and still has the full single precision.
void finishIncrements(const PoleArrays& poles,
                      const UnitContact& end,
                      const BeforeSample& before,
                      const IncrementMove& contact,
                      const ModeResidues& residues,
                      std::size_t count,
                      std::size_t channels,
                      StateIncrements& increments) noexcept;

/// Moves the increments and adds them to the states; sets `energies` to the states' |s|² in the
/// louder channel.
void joinIncrements(const PoleArrays& poles,
                    const IncrementMove& move,
                    const StateIncrements& increments,
                    std::size_t count,
                    std::size_t channels,
                    ModeStates& states,
                    AlignedVector<float>& energies) noexcept;

/// Moves the states of `count` modes from `first` on by free motion over any time, with a relative
/// error of single precision; sets their `energies` to |s|² in the louder channel.
void moveStates(const PoleArrays& poles,
                const IncrementMove& move,
                std::size_t first,
                std::size_t count,
                std::size_t channels,
                ModeStates& states,
                AlignedVector<float>& energies) noexcept;

} // namespace idiophone
