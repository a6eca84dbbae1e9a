// SPDX-License-Identifier: Apache-2.0
// The response of a mode to a raised-cosine force, in closed form (docs/decisions/0014): a forced
// part during the contact, and free motion that starts and ends with it.
#pragma once

#include "Synth/ModalPole.h"

#include <complex>
#include <span>

namespace idiophone {

/// The part of the response that follows the force f(t) = (1/T)(1 − cos Ωt), Ω = 2π/T, for a mode
/// of residue 1 whose free motion is multiplied by e^{−δt}: v(t) = steady + Re(swing e^{iΩt}). With
/// V(s) = s/(s² + d s + λ), steady = V(δ)/T and swing = −V(δ + iΩ)/T. StrikeKernel.h sums these as
/// G0 and H. This form holds for real roots too. If δ = 0, a constant force causes no velocity.
///
/// The whole response adds free motion: it starts from −`motion(1)` at the start of the contact,
/// and `motion(1)` is added again at its end.
class ForcedResponse {
public:
    ForcedResponse(const ModalPole& pole, double contactSeconds, double dampingPerSecond) noexcept;

    double steadyVelocity() const noexcept { return steady; }
    std::complex<double> swingVelocity() const noexcept { return swing; }

    /// Returns velocity and displacement at the time when e^{iΩt} is `phase`.
    Motion motion(std::complex<double> phase) const noexcept;

private:
    double contactRate;                     ///< 1/T
    double constantStiffness;               ///< P(δ), P(s) = s² + d s + λ
    std::complex<double> swingStiffness;    ///< P(δ + iΩ)
    std::complex<double> stiffnessIncrease; ///< P(δ + iΩ) − P(δ), without cancellation
    double steady;
    std::complex<double> swing;
};

/// Returns the contact time to use for T. If a resonance f has |fT − 1| < 1 %, the closed form
/// would be the small difference of large numbers. T then changes by up to 3 %, to the nearest time
/// that is clear of all resonances. If there is none, T changes to the time farthest from them.
double contactSecondsClearOf(std::span<const double> resonancesHz, double seconds) noexcept;

} // namespace idiophone
