// SPDX-License-Identifier: Apache-2.0
// The law of damping over frequency: the only place that contains it. It does not cover radiation
// or the thickness of a body (docs/materials.md).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

/// The sum of three laws. The amplitude of a mode of undamped angular frequency ω decays at the
/// rate α = d(ω)/2 [1/s], where
///
///     d(ω) = γ + χ ω + η ω²
///
/// γ and η are Rayleigh damping (Raghuvanshi & Lin 2006, eq. 2). χ is the loss factor of structural
/// damping: twice the damping ratio ζ, or 1/Q, the same at all frequencies (Cremer & Heckl).
struct DampingLaw {
    double fluidPerSecond = 0;      ///< γ ≥ 0, multiplies the mass matrix
    double viscoelasticSeconds = 0; ///< η ≥ 0, multiplies the stiffness matrix
    double lossFactor = 0;          ///< χ ≥ 0

    /// Returns d [1/s] of the mode of eigenvalue λ = ω² [rad²/s²] ≥ 0. Takes a root only if there
    /// is a loss factor, because grouping calls this for every mode.
    double perSecond(double eigenvalue) const noexcept {
        const double rayleigh = fluidPerSecond + viscoelasticSeconds * eigenvalue;
        return lossFactor == 0 ? rayleigh : rayleigh + lossFactor * std::sqrt(eigenvalue);
    }

    bool operator==(const DampingLaw&) const = default;

    /// Returns the law that damps this many times as fast.
    DampingLaw times(double factor) const noexcept {
        return {factor * fluidPerSecond, factor * viscoelasticSeconds, factor * lossFactor};
    }
};

/// The deviation of a mode's damping from its material's law (`PoleLaw::pole`).
struct ModeDamping {
    double scale = 1;          ///< factor ≥ 0 of the law's damping
    double extraPerSecond = 0; ///< additional decay rate α ≥ 0 for any material

    bool operator==(const ModeDamping&) const = default;
};

/// Returns the frequency in Hz of a mode with decay rate α: √(λ − α²)/2π, or 0 if it is
/// over-damped.
inline double dampedFrequencyHz(double eigenvalue, double decayPerSecond) noexcept {
    return std::sqrt(std::max(0.0, eigenvalue - decayPerSecond * decayPerSecond)) /
           (2 * std::numbers::pi);
}

} // namespace idiophone
