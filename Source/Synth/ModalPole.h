// The equation of one mode, z'' + d z' + λ z = 0, solved in closed form for any damping. No
// samples, no object: numbers in, numbers out.
#pragma once

#include "Object/DampingLaw.h"

#include <cstddef>
#include <span>

namespace idiophone {

/// λ [rad²/s²] > 0 and d [1/s] ≥ 0 (Raghuvanshi & Lin 2006, eq. 6, m_i = 1).
struct ModalPole {
    double stiffness = 1;
    double damping = 0;

    bool operator==(const ModalPole&) const = default;
};

/// How the eigenvalues of an object's reference become poles now: λ = ratio · λ_ref, and d = scale
/// times the damping law at that λ, plus twice the extra decay, which grows with the frequency.
struct PoleLaw {
    double eigenvalueRatio = 1;
    DampingLaw damping;

    bool operator==(const PoleLaw&) const = default;
    ModalPole pole(double referenceEigenvalue, const ModeDamping& mode = {}) const noexcept;
};

/// The λ at which a mode under this law sounds at `dampedFrequency` [rad/s] > 0: λ − d(λ)²/4 = ω².
/// Its extra decay is that at `referenceEigenvalue` > 0. At most 2ω², ζ = 1/√2: a law that damps
/// more leaves no pitch to keep. Continuous in all arguments. Takes at most twenty steps, mostly
/// three.
double stiffnessSoundingAt(double dampedFrequency,
                           const DampingLaw& damping,
                           const ModeDamping& mode = {},
                           double referenceEigenvalue = 1) noexcept;

/// The damping of a mode or group; where there are none, all keep to the law.
inline ModeDamping dampingOf(std::span<const ModeDamping> dampings, std::size_t index) noexcept {
    return dampings.empty() ? ModeDamping() : dampings[index];
}

/// Velocity z' and displacement z of a mode at one instant.
struct Motion {
    double velocity = 0;
    double displacement = 0;
};

/// The same in the coordinates of a pole. Where the mode oscillates (`isOscillating`) x + iy is the
/// complex velocity amplitude s = 2 c ω⁺, so that v(t) = Re(s e^{ω⁺t}). Close to critical damping
/// and beyond, where s is ill-conditioned or does not exist, x = z' and y = √λ z.
struct ModalState {
    double x = 0;
    double y = 0;
};

/// A real 2 × 2 matrix that takes a state on in time; its first row gives the velocity.
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

/// Whether the damped angular frequency is at least a tenth of √λ.
bool isOscillating(const ModalPole& pole) noexcept;

/// √λ/2π: the frequency by which the audible band is judged at any damping.
double naturalFrequencyHz(const ModalPole& pole) noexcept;

/// √(λ − d²/4) [rad/s], 0 where over-damped.
double dampedFrequency(const ModalPole& pole) noexcept;

/// The state after `seconds` ≥ 0 of free motion, exact in every regime.
Propagator propagator(const ModalPole& pole, double seconds) noexcept;

ModalState stateOf(const ModalPole& pole, const Motion& motion) noexcept;
Motion motionOf(const ModalPole& pole, const ModalState& state) noexcept;

/// A and α such that |v(t)| ≤ A e^{−αt} for all t ≥ 0 (Raghuvanshi & Lin 2006, eq. 13 and 14),
/// where A = 2|c||ω⁺| and α = −Re ω⁺. Beyond critical damping A = |c⁺ω⁺| + |c⁻ω⁻| with the slower
/// root.
double amplitudeBound(const ModalPole& pole, const ModalState& state) noexcept;
double decayBound(const ModalPole& pole) noexcept;

} // namespace idiophone
