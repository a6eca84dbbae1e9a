// Closed forms for the motion that a strike's raised-cosine contacts leave in modes, and for the
// motion during a long contact. ContactTrain.h says which contacts a strike has.
#pragma once

#include "Instrument/ContactTrain.h"

#include <complex>

namespace idiophone {

/// Returns the magnitude of a strike's impulse [Ns].
double impulseOf(const Strike& strike) noexcept;

/// Returns the complex amplitude, at the start of the strike, of the velocity with which a mode of
/// residue 1 rings afterwards. The mode decays as e^(−αt): `decay` is α [1/s], `omega` is its
/// damped frequency [rad/s].
/// At its end a raised cosine (I/T)(1 − cos Ωt) leaves I (e^x − 1) 4π²/(x (x² + 4π²)), x = pT, at
/// the pole p.
std::complex<double>
ringingVelocity(const ContactTrain& train, double decay, double omega) noexcept;

/// The motion during a long contact. If the pulse has a null at the lowest mode, there is no other
/// motion. Stiff modes follow the force: v = Σ r (I/T) Ω/(λ − Ω²) · sin Ωt. Their acceleration,
/// divided by ω, is Ω/ω times that amplitude, a quarter of a turn later.
class PressedMotion {
public:
    PressedMotion() = default;
    explicit PressedMotion(const Strike& strike) noexcept;

    /// Returns the amplitudes for a residue of 1 (real part) and of i (imaginary part) of a mode of
    /// that λ [rad²/s²] and ω [rad/s]. Returns 0 for a less stiff mode, which rings on and is
    /// louder.
    std::complex<double> velocity(double stiffness, double modeOmega) const noexcept;
    /// Returns the K-weighted energy (power times seconds) of a sine of this amplitude during the
    /// contact.
    double energy(double amplitude) const noexcept;

private:
    double seconds = 1;
    double omega = 0;
    double forceRate = 0;
};

} // namespace idiophone
