// SPDX-License-Identifier: Apache-2.0
// The equation of one mode, z'' + d z' + λ z = 0, solved in closed form for any damping. It knows
// neither samples nor objects.
#pragma once

#include "Object/DampingLaw.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <numbers>
#include <span>

namespace idiophone {

/// λ [rad²/s²] > 0 and d [1/s] ≥ 0 (Raghuvanshi & Lin 2006, eq. 6, m_i = 1).
struct ModalPole {
    double stiffness = 1;
    double damping = 0;

    bool operator==(const ModalPole&) const = default;
};

// The limits, far outside the audible range, keep extreme settings from overflowing.
inline constexpr double smallestStiffness = 1e-6, largestStiffness = 1e18, largestDamping = 1e12;

/// Converts an object's reference eigenvalues to poles: λ = ratio · λ_ref. d is scale times the
/// damping law at that λ, plus twice the extra decay, which grows with the frequency.
struct PoleLaw {
    double eigenvalueRatio = 1;
    DampingLaw damping;
    double extraRatio = 1; ///< multiplies the extra decay

    bool operator==(const PoleLaw&) const = default;
    double stiffness(double referenceEigenvalue) const noexcept {
        return std::clamp(eigenvalueRatio * referenceEigenvalue, smallestStiffness,
                          largestStiffness);
    }
    double extraFactor() const noexcept { return extraRatio * std::sqrt(eigenvalueRatio); }
    ModalPole pole(double referenceEigenvalue, const ModeDamping& mode = {}) const noexcept;
};

/// Returns the λ at which a mode under this law sounds at `dampedFrequency` ω [rad/s] > 0: λ −
/// d(λ)²/4 = ω². The mode's extra decay is given at `referenceEigenvalue` > 0. The result is at
/// most 2ω² (ζ = 1/√2): under a law that damps more there is no pitch to keep. Continuous in all
/// arguments. Takes at most 20 Newton steps, mostly 3.
double stiffnessSoundingAt(double dampedFrequency,
                           const DampingLaw& damping,
                           const ModeDamping& mode = {},
                           double referenceEigenvalue = 1) noexcept;

/// Returns the damping of a mode or group; if `dampings` is empty, all follow the law.
inline ModeDamping dampingOf(std::span<const ModeDamping> dampings, std::size_t index) noexcept {
    return dampings.empty() ? ModeDamping() : dampings[index];
}

/// Velocity z' and displacement z of a mode at one instant.
struct Motion {
    double velocity = 0;
    double displacement = 0;
};

/// The motion in the coordinates of a pole. If the mode oscillates (`isOscillating`), x + iy is the
/// complex velocity amplitude s = 2 c ω⁺, so that v(t) = Re(s e^{ω⁺t}). Near critical damping and
/// beyond, where s is ill-conditioned or undefined, x = z' and y = √λ z.
struct ModalState {
    double x = 0;
    double y = 0;
};

/// A real 2 × 2 matrix that moves a state in time; its first row gives the velocity.
struct Propagator {
    double xx = 1, xy = 0, yx = 0, yy = 1;

    ModalState operator*(const ModalState& s) const noexcept {
        return {xx * s.x + xy * s.y, yx * s.x + yy * s.y};
    }
    Propagator operator*(const Propagator& b) const noexcept {
        return {xx * b.xx + xy * b.yx, xx * b.xy + xy * b.yy, yx * b.xx + yy * b.yx,
                yx * b.xy + yy * b.yy};
    }
};

/// ω_d² > 0.01 λ keeps the ratio of s to the motion below 10.
inline constexpr double oscillatingShare = 0.99;

/// Returns whether the damped angular frequency is at least a tenth of √λ.
inline bool isOscillating(const ModalPole& pole) noexcept {
    return pole.damping * pole.damping < 4 * oscillatingShare * pole.stiffness;
}

/// Returns the λ of a natural frequency, which decides at any damping whether a mode is in the
/// audible band.
constexpr double stiffnessAt(double naturalHz) noexcept {
    const double omega = 2 * std::numbers::pi * naturalHz;
    return omega * omega;
}
/// Returns √λ/2π.
double naturalFrequencyHz(const ModalPole& pole) noexcept;

/// Returns √(λ − d²/4) [rad/s], or 0 if over-damped.
double dampedFrequency(const ModalPole& pole) noexcept;

/// Returns the free motion over `seconds` ≥ 0, exact in every regime.
Propagator propagator(const ModalPole& pole, double seconds) noexcept;

ModalState stateOf(const ModalPole& pole, const Motion& motion) noexcept;
Motion motionOf(const ModalPole& pole, const ModalState& state) noexcept;

/// Return A and α such that |v(t)| ≤ A e^{−αt} for all t ≥ 0 (Raghuvanshi & Lin 2006, eq. 13 and
/// 14), with A = 2|c||ω⁺| and α = −Re ω⁺. Beyond critical damping A = |c⁺ω⁺| + |c⁻ω⁻| and α is that
/// of the slower root.
double amplitudeBound(const ModalPole& pole, const ModalState& state) noexcept;
double decayBound(const ModalPole& pole) noexcept;

} // namespace idiophone
