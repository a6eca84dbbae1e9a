// How fast a vibration dies away, by its frequency: the one place that knows the law. It knows
// nothing of radiation or of a body's thickness (docs/materials.md).
#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

/// Three laws in sum. A mode of undamped angular frequency ω loses amplitude at α = d(ω)/2 per
/// second, where
///
///     d(ω) = γ + χ ω + η ω²
///
/// γ and η are Rayleigh damping (Raghuvanshi & Lin 2006, eq. 2). χ is the loss factor of structural
/// damping: twice the damping ratio ζ and 1/Q, the same at all frequencies (Cremer & Heckl).
struct DampingLaw {
    double fluidPerSecond = 0;      ///< γ ≥ 0, multiplies the mass matrix
    double viscoelasticSeconds = 0; ///< η ≥ 0, multiplies the stiffness matrix
    double lossFactor = 0;          ///< χ ≥ 0

    /// d [1/s] of the mode of eigenvalue λ = ω² [rad²/s²] ≥ 0. The root is only taken where there
    /// is a loss factor: grouping asks this of every mode.
    double perSecond(double eigenvalue) const noexcept {
        const double rayleigh = fluidPerSecond + viscoelasticSeconds * eigenvalue;
        return lossFactor == 0 ? rayleigh : rayleigh + lossFactor * std::sqrt(eigenvalue);
    }

    bool operator==(const DampingLaw&) const = default;
};

/// How a mode's damping differs from what its material's law makes of it (`PoleLaw::pole`).
struct ModeDamping {
    double scale = 1;          ///< ≥ 0 of the law
    double extraPerSecond = 0; ///< ≥ 0 more decay α, whatever the material

    bool operator==(const ModeDamping&) const = default;
};

/// The frequency in Hz at which a mode sounds that loses amplitude at α: √(λ − α²)/2π; 0 where it
/// is over-damped.
inline double dampedFrequencyHz(double eigenvalue, double decayPerSecond) noexcept {
    return std::sqrt(std::max(0.0, eigenvalue - decayPerSecond * decayPerSecond)) /
           (2 * std::numbers::pi);
}

} // namespace idiophone
