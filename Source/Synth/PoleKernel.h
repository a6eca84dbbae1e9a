// What follows from many poles at once, with SIMD chosen at run time: rotations and tables of
// oscillating modes, and free motion over any time. Arrays in, arrays out; counts are whole blocks.
#pragma once

#include <cstddef>

namespace idiophone {

/// Arrays over modes; see ModalBankKernel.h for the rotations and tables.
struct PoleArrays {
    const double* stiffness;   ///< λ
    const double* damping;     ///< d
    double* decay;             ///< α = d/2
    double* frequency;         ///< ω_d = √(λ − α²), 0 where over-damped
    double* velocityShare;     ///< α/ω_d: y of the state after an impulse that makes x = 1
    float* halfTurnsPerSample; ///< of ω_d
    float* octavesPerSample;   ///< −α in powers of two
    float* sampleRe;           ///< ρ
    float* sampleIm;
    float* subBlockRe; ///< ρ^16
    float* subBlockIm;
    double* cellRe; ///< ρ^64
    double* cellIm;
    float* tables;
};

/// Fills in all but λ and d. Modes that do not oscillate are left for the caller to correct.
void rotationsOfPoles(const PoleArrays& arrays, std::size_t count, double sampleSeconds) noexcept;

/// x + iy times `factor` e^{(−α + iω)t}: free motion of oscillating modes over `seconds`, which may
/// be hours.
void rotateModes(const double* decay,
                 const double* frequency,
                 std::size_t count,
                 double seconds,
                 double factor,
                 double* x,
                 double* y) noexcept;

} // namespace idiophone
