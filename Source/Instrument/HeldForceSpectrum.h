// The spectrum of the force of a scrape or roll, up to a constant that does not depend on the
// object: what ContactForce renders, in closed form. It knows neither the object's residues nor
// samples.
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
    /// Of a surface passed at that speed ≥ 0 (a slower one than the surface's slowest counts as
    /// that), under settings and with coupled modes as ContactForce takes them.
    HeldForceSpectrum(const Surface& surface,
                      double speedMetresPerSecond,
                      const ContactForceSettings& settings,
                      std::span<const CoupledMode> coupledModes,
                      double sampleRateHz) noexcept;

    /// The two-sided power spectrum at an angular frequency > 0 [rad/s], without the coupled modes:
    /// smooth.
    double smoothPower(double omega) const noexcept;

    /// What a mode of `decay` α [1/s] at ω_i = `omega` takes from the force of a note, and
    /// `release` [1/s] more after it: the mean of the power spectrum over its resonance (α/π)/((ω −
    /// ω_i)² + α²). A coupled mode's filter d/(d + i(ω − ω_k)) has the mean d/(d + α + i(ω_i −
    /// ω_k)) there, as it is analytic on one side, and its square d (d + α)/|d + α + i(ω_i −
    /// ω_k)|². The mode that is coupled itself answers as (h + c d t) e^(−αt), which a note may be
    /// too short for.
    double powerTakenBy(double omega, double decay, double release) const noexcept;

private:
    double scrapePower(double omega) const noexcept;
    std::complex<double> mix(double omega) const noexcept;

    double rateHz = 1;
    double exponent = 0;
    double speedRatio = 1;
    double lowestOmega = 0, highestOmega = 0; ///< of the profile
    ResonPole reson;
    double resonGain = 1;
    double dry = 1, filtered = 0, coupled = 0;
    double lowPassPart = 0; ///< real and imaginary part of the low-pass's pole [rad/s]
    std::array<CoupledMode, ContactForce::maxCoupledModes> modes{};
    std::size_t modeCount = 0;
};

} // namespace idiophone
