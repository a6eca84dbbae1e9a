// SPDX-License-Identifier: Apache-2.0
// Poles of many modes under one law, and which of them may merge with their neighbours, with SIMD
// chosen at run time. Compiled without fused multiply-adds: the bits are those of PoleLaw::pole.
#pragma once

#include "Synth/ModalPole.h"

#include <cstdint>
#include <span>

namespace idiophone {

/// Writes `law.pole` of every mode: its λ to `stiffness` and its d to `damping`. `dampings` is
/// empty if all modes follow the law.
void polesOfLaw(const PoleLaw& law,
                std::span<const double> referenceEigenvalues,
                std::span<const ModeDamping> dampings,
                double* stiffness,
                double* damping) noexcept;

/// Sets mayMerge[i] to 0 if mode i, for any damping and kind of mode, cannot join a group whose
/// first mode is the mode before, of poles [−1] (see `groupModes`). `count` is a multiple of 8.
void findNeighbours(const double* stiffness,
                    const double* damping,
                    std::size_t count,
                    double compression,
                    std::uint8_t* mayMerge) noexcept;

} // namespace idiophone
