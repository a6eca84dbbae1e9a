// How a mode answers a raised-cosine force, in closed form (docs/decisions/0014): a steady part
// while the contact lasts and a free part that starts and ends with it.
#pragma once

#include "Synth/ModalPole.h"

#include <complex>
#include <span>

namespace idiophone {

/// The part of the response that follows the force f(t) = (1/T)(1 − cos Ωt), Ω = 2π/T, of a mode of
/// residue 1 whose free motion is multiplied by e^{−δt}: v(t) = steady + Re(swing e^{iΩt}), with
/// V(s) = s/(s² + d s + λ), steady = V(δ)/T and swing = −V(δ + iΩ)/T. These are called G0 and
/// H where they are summed (StrikeKernel.h); they hold for real roots too in this form; without δ
/// no velocity answers a constant force.
///
/// The whole response is this plus free motion: from −`motion(1)` at the contact's start and, at
/// its end, with `motion(1)` added again.
class ForcedResponse {
public:
    ForcedResponse(const ModalPole& pole, double contactSeconds, double dampingPerSecond) noexcept;

    double steadyVelocity() const noexcept { return steady; }
    std::complex<double> swingVelocity() const noexcept { return swing; }

    /// Velocity and displacement where e^{iΩt} is `phase`.
    Motion motion(std::complex<double> phase) const noexcept;

private:
    double contactRate;                     ///< 1/T
    double constantStiffness;               ///< P(δ), P(s) = s² + d s + λ
    std::complex<double> swingStiffness;    ///< P(δ + iΩ)
    std::complex<double> stiffnessIncrease; ///< P(δ + iΩ) − P(δ), without cancellation
    double steady;
    std::complex<double> swing;
};

/// The contact time to use for T: T itself, or up to 3 % shorter or longer where a resonance f has
/// |fT − 1| < 1 % and the closed form would be the small difference of large numbers: the nearest
/// time that is clear of all resonances, or that which is clearest.
double contactSecondsClearOf(std::span<const double> ascendingResonancesHz,
                             double seconds) noexcept;

} // namespace idiophone
