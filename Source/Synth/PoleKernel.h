// SPDX-License-Identifier: Apache-2.0
// Computes rotations and tables of oscillating modes from their poles, with SIMD chosen at run
// time. Counts are whole blocks.
#pragma once

#include "Synth/AlignedVector.h"
#include "Synth/ModalBankKernel.h"

#include <cstddef>

namespace idiophone {

/// Arrays over modes; see ModalBankKernel.h for the rotations and tables.
struct PoleArrays {
    explicit PoleArrays(std::size_t modes)
        : tables(2 * subBlockSamples * modes), stiffness(modes), damping(modes), cellRe(modes),
          cellIm(modes), sampleRe(modes), sampleIm(modes), subBlockRe(modes), subBlockIm(modes),
          velocityShare(modes), decay(modes), frequency(modes), halfTurnsPerSample(modes),
          octavesPerSample(modes) {}

    AlignedVector<float> tables;                 ///< [modes,2,16]
    AlignedVector<double> stiffness;             ///< λ
    AlignedVector<double> damping;               ///< d
    AlignedVector<double> cellRe, cellIm;        ///< ρ^64
    AlignedVector<float> sampleRe, sampleIm;     ///< ρ
    AlignedVector<float> subBlockRe, subBlockIm; ///< ρ^16
    // Strikes on sleeping objects read the following, which therefore lie side by side.
    AlignedVector<double> velocityShare;     ///< α/ω_d: y after an impulse that makes x = 1
    AlignedVector<double> decay;             ///< α = d/2
    AlignedVector<double> frequency;         ///< ω_d = √(λ − α²), 0 where over-damped
    AlignedVector<float> halfTurnsPerSample; ///< of ω_d; below 1 within the band
    AlignedVector<float> octavesPerSample;   ///< −α in powers of two
};

/// The band in which modes are audible, from `lowestHz` to below `highestHz`.
struct AudibleBand {
    double lowestHz = 0;
    double highestHz = 0;
};

/// Fills in the arrays from `velocityShare` on, from λ and d. Sets audibles[g] to 1 in the band and
/// 0 elsewhere. Writes the damped frequencies of lightly damped modes in the band to
/// `resonancesHz`, which has room for count + 8. Returns their number, and whether every mode
/// oscillates.
struct PolesFound {
    std::size_t resonances = 0;
    bool allOscillate = true;
};
PolesFound coefficientsOfPoles(PoleArrays& poles,
                               std::size_t count,
                               double sampleSeconds,
                               const AudibleBand& band,
                               float* audibles,
                               double* resonancesHz) noexcept;

/// Fills in the rotations and tables of `count` modes from `first` on, for which
/// `coefficientsOfPoles` has been called. The caller corrects modes that do not oscillate.
void rotationsOfPoles(PoleArrays& poles,
                      std::size_t first,
                      std::size_t count,
                      double sampleSeconds) noexcept;

} // namespace idiophone
