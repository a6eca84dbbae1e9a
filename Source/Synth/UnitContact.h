// SPDX-License-Identifier: Apache-2.0
// The response of modes of residue 1 to a contact.
#pragma once

#include "Synth/AlignedVector.h"

#include <complex>
#include <cstddef>

namespace idiophone {

class ModePoles;

/// A raised-cosine pulse at one instant, and the damper's δ.
struct PulseInstant {
    double contactSeconds = 0;        ///< T
    double dampingPerSecond = 0;      ///< δ
    std::complex<double> phase{1, 0}; ///< e^{iΩt}
};

/// The state of the forced part (ContactPulse.h) at one instant, and its amplitudes; [modes].
struct UnitContact {
    explicit UnitContact(std::size_t modes)
        : x(modes), y(modes), steady(modes), swingRe(modes), swingIm(modes), quadratureRe(modes),
          quadratureIm(modes) {}

    /// Computes the forced part of a contact. There must be room for the modes.
    void setForced(const ModePoles& poles, const PulseInstant& pulse) noexcept;
    /// Computes the motion after an impulse, and no amplitudes.
    void setImpulse(const ModePoles& poles) noexcept;

    AlignedVector<float> x, y;
    AlignedVector<float> steady;           ///< G0
    AlignedVector<float> swingRe, swingIm; ///< H
    /// K: factor of G0 and H for a residue of i.
    AlignedVector<float> quadratureRe, quadratureIm;
};

} // namespace idiophone
