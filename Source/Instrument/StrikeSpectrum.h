// Closed forms for the motion that a strike's raised-cosine contacts leave in modes, and for the
// motion during a long contact. ContactTrain.h says which contacts a strike has.
#pragma once

#include "Instrument/ContactTrain.h"
#include "Synth/ModalPole.h"

#include <complex>

namespace idiophone {

/// Returns the magnitude of a strike's impulse [Ns].
double impulseOf(const Strike& strike) noexcept;

/// Returns the complex amplitude, turned back to the start of the strike, of the velocity with
/// which a mode of residue 1 rings. The mode decays as e^(−αt): `decay` is α [1/s], `omega` is its
/// damped frequency [rad/s]. Contacts of no duration are impulses. At its end a raised cosine
/// (I/T)(1 − cos Ωt) leaves I (e^x − 1) 4π²/(x (x² + 4π²)), x = pT, at the pole p. The magnitude is
/// that of 0.275 T before the end, so that |A|²/4α is the energy of the motion during the contact
/// too: within 0.3 dB for αT up to 4, if the mode's period is longer than T. Over longer contacts
/// stiff modes follow the force (`PressedMotion`).
std::complex<double>
ringingVelocity(const ContactTrain& train, double decay, double omega) noexcept;

/// The motion during a long contact. If the pulse has a null at the lowest mode, there is no other
/// motion. Stiff and heavily damped modes follow the force: v = Σ r (I/T) Ω/(λ − Ω² + iΩd) · sin
/// Ωt. Their acceleration, divided by ω, is Ω/ω times that amplitude, a quarter of a turn later.
class PressedMotion {
public:
    PressedMotion() = default;
    PressedMotion(const Strike& strike, double sampleRateHz) noexcept;

    /// Returns whether the mode stops with the contact, because it is so heavily damped.
    bool holds(const ModalPole& pole) const noexcept;
    /// Returns the complex amplitude for a mode of that residue. Returns 0 for a less stiff mode,
    /// which rings on and is louder.
    std::complex<double> velocity(const ModalPole& pole,
                                  std::complex<double> residue) const noexcept;
    /// Returns the K-weighted energy (power times seconds) of a sine of this amplitude during the
    /// contact.
    double energy(double amplitude) const noexcept;

private:
    double seconds = 1;
    double omega = 0;
    double forceRate = 0;
};

} // namespace idiophone
