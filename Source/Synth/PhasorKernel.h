// SPDX-License-Identifier: Apache-2.0
// Interpolates complex numbers by magnitude and phase, with SIMD chosen at run time. Compiled
// without fused multiply-adds: the bits are those of `phasorBetween`.
#pragma once

#include <complex>
#include <span>

namespace idiophone {

/// Writes `phasorBetween` of each pair (RadiationTable.h). `from` and `to` have as many elements.
void phasorsBetween(const std::complex<float>* from,
                    const std::complex<float>* to,
                    float share,
                    std::span<std::complex<float>> phasors) noexcept;

} // namespace idiophone
