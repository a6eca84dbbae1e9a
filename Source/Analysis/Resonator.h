// The tube under a bar: closed below, a quarter of a wave long. It makes the partials near its own
// louder and, since what is heard is taken from the bar, shorter.
#pragma once

#include "Object/ModalObject.h"

#include <complex>

namespace idiophone {

struct Resonator {
    double frequencyHz = 440;   ///< of the tube's first mode; it has the odd multiples too
    double radiusMetres = 0.02; ///< of its mouth
    /// By which the mouth stands off the bar's middle. In the very middle the second partial has a
    /// node, and a xylophone's twelfth would be left out.
    double offsetMetres = 0.01;
    double gapMetres = 0.02; ///< from the bar's underside to the mouth

    /// What the air in the tube opposes to a pressure at the mouth, over that of free air:
    ///
    ///     z = coth((α + ik) c/4f0) + (ka)²/4,   α = 3·10⁻⁵ √f/a,
    ///
    /// losses at the wall (Fletcher & Rossing 1998, section 8.2) and radiation from an open end of
    /// radius a (Levine & Schwinger 1948; at most 1).
    std::complex<double> relativeImpedance(double frequencyHz) const;

    /// Pressure at the mouth over ρcv, v the velocity of the bar above it: that of a piston of the
    /// mouth's size on its axis, at the distance g of the gap, 2 |sin(k (√(a² + g²) − g)/2)|.
    double drive(double frequencyHz) const;

    /// Volume flow through the mouth over that of the bar's surface above it, drive/|z|.
    double flowGain(double frequencyHz) const;
};

/// Gives each mode what the tube radiates, a monopole of the volume flow S g φ (S the mouth, g the
/// gain, φ the shape above it), and what the tube takes from it, the power that flows in through
/// the mouth over twice the energy: Δα = ρ c S (p φ)²/2 · Re 1/z with p the drive. The phase
/// between tube and bar is lost, so that their powers add; the sign is that of a blow on the
/// middle, which is heard alike near and far. Like the bar's decay, the tube's share stays when
/// material or size change: it is cut anew for the bar.
///
/// The object is a tuned bar, with shapes along the middle of its top, and has radiation weights,
/// which are means over `surfaceAreaM2`.
void addResonator(ModalObject& object, const Resonator& resonator, double surfaceAreaM2);

/// The tube's length in metres, from the closed end to the mouth: c/4f − 0.61 r.
double tubeLengthMetres(const Resonator& resonator);

} // namespace idiophone
