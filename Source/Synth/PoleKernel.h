// Computes rotations and tables of oscillating modes from their poles, and free motion over any
// time, with SIMD chosen at run time. Arrays in, arrays out; counts are whole blocks.
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

/// Fills in all arrays but λ and d. The caller corrects modes that do not oscillate.
void rotationsOfPoles(const PoleArrays& arrays, std::size_t count, double sampleSeconds) noexcept;

/// Multiplies x + iy by `factor` e^{(−α + iω)t}: free motion of oscillating modes over `seconds`,
/// which may be hours.
void rotateModes(const double* decay,
                 const double* frequency,
                 std::size_t count,
                 double seconds,
                 double factor,
                 double* x,
                 double* y) noexcept;

} // namespace idiophone
