// SPDX-License-Identifier: Apache-2.0
// Computes the effect of a contact on many modes, with SIMD chosen at run time: residues from
// shapes, and the closed-form response to a raised cosine.
#pragma once

#include "Synth/ModeResidues.h"
#include "Synth/ModeRun.h"
#include "Synth/PoleKernel.h"
#include "Synth/Strike.h"
#include "Synth/UnitContact.h"

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

/// Computes struckGains[i] = φ_i(p) · struck and listeningGains[i] = φ_i(p) · listening for any
/// `count` of modes.
void projectShapes(const ShapePoint& point,
                   const std::array<float, 3>& struck,
                   const std::array<float, 3>& listening,
                   std::size_t count,
                   float* struckGains,
                   float* listeningGains) noexcept;

/// Computes the forced part of a contact for `count` oscillating modes (whole blocks).
void forcedStates(const PulseInstant& pulse,
                  const PoleArrays& poles,
                  std::size_t count,
                  UnitContact& unit) noexcept;

/// The sound of a forced part with complex residues r: Σ (Re r + Im r Re K) G0 and Σ (Re r + Im r
/// K) H.
struct ForcedSum {
    double steady = 0;
    std::complex<double> swing;
};
/// Adds the modes of a run to `sum`.
void sumForced(const ChannelResidues& residues,
               const UnitContact& unit,
               const ModeRun& run,
               ForcedSum& sum) noexcept;

/// Writes output[k] = steady + Re(swing e^{iθk}) for k < `count` ≤ 64; `output` has room for 64.
void raisedCosine(double steady,
                  std::complex<double> swing,
                  double radiansPerSample,
                  std::size_t count,
                  float* output) noexcept;

} // namespace idiophone
