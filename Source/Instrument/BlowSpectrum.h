// How much motion a blow leaves in modes, and while it lasts: closed forms of raised-cosine
// contacts. Which contacts a blow is made of stands in ContactTrain.h.
#pragma once

#include "Instrument/ContactTrain.h"

#include <complex>

namespace idiophone {

/// The length of a strike's impulse [Ns].
double impulseOf(const Strike& strike) noexcept;

/// The velocity, for a residue of 1, with which a mode that falls as e^(−αt) (`decay` α [1/s],
/// `omega` its damped frequency [rad/s]) rings after the blow, as its complex amplitude at the
/// start of it. A raised cosine (I/T)(1 − cos Ωt) leaves, at its end, I (e^x − 1) 4π²/(x (x² +
/// 4π²)), x = pT, at the pole p.
std::complex<double>
ringingVelocity(const ContactTrain& train, double decay, double omega) noexcept;

/// The motion while a long contact lasts, which is all there is where the pulse has a null at the
/// lowest mode: stiff modes follow its force, in v = Σ r (I/T) Ω/(λ − Ω²) · sin Ωt, and in
/// acceleration over frequency ω as Ω/ω of that a quarter of a turn later.
class PressedMotion {
public:
    PressedMotion() = default;
    explicit PressedMotion(const Strike& strike) noexcept;

    /// The amplitudes for a residue of 1 (real part) and of i (imaginary part) of a mode of that λ
    /// [rad²/s²] and ω [rad/s]; 0 of what is less stiff, which rings on, and louder.
    std::complex<double> velocity(double stiffness, double modeOmega) const noexcept;
    /// The K-weighted energy, power times seconds, of that amplitude.
    double energy(double amplitude) const noexcept;

private:
    double seconds = 1;
    double omega = 0;
    double forceRate = 0;
};

} // namespace idiophone
