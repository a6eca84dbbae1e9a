// The spectrum of the force of a scrape or roll, in closed form. It matches the output of
// ContactForce up to a constant that does not depend on the object. It uses neither the object's
// residues nor samples.
#pragma once

#include "Synth/ContactForce.h"
#include "Synth/Reson.h"
#include "Synth/Surface.h"

#include <array>
#include <complex>
#include <cstddef>
#include <span>

namespace idiophone {

/// Does not allocate.
class HeldForceSpectrum {
public:
    HeldForceSpectrum() = default;
    /// Describes a surface passed at a speed ≥ 0, raised to the surface's minimum speed. Settings
    /// and coupled modes are those of ContactForce.
    HeldForceSpectrum(const Surface& surface,
                      double speedMetresPerSecond,
                      const ContactForceSettings& settings,
                      std::span<const CoupledMode> coupledModes,
                      double sampleRateHz) noexcept;

    /// Returns the two-sided power spectrum, without the coupled modes, at an angular frequency > 0
    /// [rad/s]. It is smooth.
    double smoothPower(double omega) const noexcept;

    /// Returns the power that a mode of `decay` α [1/s] at ω_i = `omega` takes from the force of a
    /// note; `release` [1/s] adds to the decay after the note. This is the mean of the power
    /// spectrum over the mode's resonance (α/π)/((ω − ω_i)² + α²). A coupled mode's filter d/(d +
    /// i(ω − ω_k)) has the mean d/(d + α + i(ω_i − ω_k)) there, because it is analytic on one side.
    /// Its square has the mean d (d + α)/|d + α + i(ω_i − ω_k)|². If the mode is coupled itself, it
    /// answers as (h + c d t) e^(−αt), which may last longer than the note.
    double powerTakenBy(double omega, double decay, double release) const noexcept;

private:
    double scrapePower(double omega) const noexcept;
    std::complex<double> mix(double omega) const noexcept;

    double rateHz = 1;
    double exponent = 0;
    double speedRatio = 1;
    double lowestOmega = 0, highestOmega = 0; ///< band of the profile [rad/s]
    ResonPole reson;
    double resonGain = 1;
    double dry = 1, filtered = 0, coupled = 0;
    double lowPassPart = 0; ///< real and imaginary part of the low-pass pole [rad/s]
    std::array<CoupledMode, ContactForce::maxCoupledModes> modes{};
    std::size_t modeCount = 0;
};

} // namespace idiophone
