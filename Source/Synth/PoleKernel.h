// What follows from many poles at once, with SIMD chosen at run time: rotations and tables of
// oscillating modes, and free motion over any time. Arrays in, arrays out; counts are whole blocks.
#pragma once

#include <cstddef>

namespace idiophone {

/// Arrays over modes; see ModalBankKernel.h for the rotations and tables.
struct PoleArrays {
    const double* stiffness; ///< λ
    const double* damping;   ///< d
    double* decay;           ///< α = d/2
    double* frequency;       ///< ω_d = √(λ − α²), 0 where over-damped
    /// y of the state from motion: displacementShare z + velocityShare z'.
    double* displacementShare; ///< λ/ω_d
    double* velocityShare;     ///< α/ω_d
    float* sampleRe;           ///< ρ
    float* sampleIm;
    float* turnRe;
    float* turnIm;
    double* cellRe;
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

/// The same for less than a sample, to single precision and in half the time.
void turnModes(const double* decay,
               const double* frequency,
               std::size_t count,
               double seconds,
               double factor,
               double* x,
               double* y) noexcept;

/// ρ and ρ¹⁶.
struct SampleRotations {
    const float* sampleRe;
    const float* sampleIm;
    const float* turnRe;
    const float* turnIm;
};

/// Adds to sumX, sumY the states x, y after `samples` (below 64) of free motion, to single
/// precision, times `factor`.
void addMovedModes(const SampleRotations& rotations,
                   std::size_t count,
                   std::size_t samples,
                   double factor,
                   const double* x,
                   const double* y,
                   double* sumX,
                   double* sumY) noexcept;

} // namespace idiophone
