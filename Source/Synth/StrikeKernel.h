// Computes the effect of a contact on many modes, with SIMD chosen at run time: residues from
// shapes, and the closed-form response to a raised cosine. Arrays in, arrays out.
#pragma once

#include "Synth/Strike.h"

#include <array>
#include <complex>
#include <cstddef>

namespace idiophone {

/// A few rows of shapes [M,3] and the weights of their mean.
struct ShapePoint {
    std::array<const float*, maximumShapeRows> rows{};
    std::array<float, maximumShapeRows> weights{};
    std::size_t used = 0;
};

/// Computes struckGains[i] = φ_i(p) · struck and listeningGains[i] = φ_i(p) · heard for any `count`
/// of modes.
void projectShapes(const ShapePoint& point,
                   const std::array<float, 3>& struck,
                   const std::array<float, 3>& heard,
                   std::size_t count,
                   float* struckGains,
                   float* listeningGains) noexcept;

/// A raised-cosine pulse at one instant, and the damper's δ.
struct PulseInstant {
    double contactSeconds = 0;        ///< T
    double dampingPerSecond = 0;      ///< δ
    std::complex<double> phase{1, 0}; ///< e^{iΩt}
};

/// Oscillating modes, −α ± iω, and the results for a residue of 1: the state of the forced part
/// (ContactPulse.h) at that instant, and its amplitudes.
struct ForcedArrays {
    const double* decay;
    const double* frequency;
    float* x;
    float* y;
    float* steady;  ///< G0
    float* swingRe; ///< H
    float* swingIm;
    float* quadratureRe; ///< K: factor of G0 and H for a residue of i
    float* quadratureIm;
};

/// `count` is a multiple of the block size.
void forcedStates(const PulseInstant& pulse,
                  const ForcedArrays& arrays,
                  std::size_t count) noexcept;

/// The amplitudes that forcedStates computed.
struct ForcedAmplitudes {
    const float* steady;
    const float* swingRe;
    const float* swingIm;
    const float* quadratureRe;
    const float* quadratureIm;
};

/// The sound of a forced part with complex residues r: Σ (Re r + Im r Re K) G0 and Σ (Re r + Im r
/// K) H over modes `first` to `first + count − 1`. sumForced adds to `sum`.
struct ForcedSum {
    double steady = 0;
    std::complex<double> swing;
};
void sumForced(const float* residuesRe,
               const float* residuesIm,
               const ForcedAmplitudes& arrays,
               std::size_t first,
               std::size_t count,
               ForcedSum& sum) noexcept;

/// Writes output[k] = steady + Re(swing e^{iθk}) for k < `count` ≤ 64; `output` has room for 64.
void raisedCosine(double steady,
                  std::complex<double> swing,
                  double radiansPerSample,
                  std::size_t count,
                  float* output) noexcept;

} // namespace idiophone
