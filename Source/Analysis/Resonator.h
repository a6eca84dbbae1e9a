// The tube under a bar: closed below, a quarter of a wave long. It makes the partials near its own
// louder and, since what is heard is taken from the bar, shorter.
#pragma once

#include "Object/ModalObject.h"

namespace idiophone {

struct Resonator {
    double frequencyHz = 440;   ///< of the tube's first mode; it has the odd multiples too
    double radiusMetres = 0.02; ///< of its mouth
    /// By which the mouth stands off the bar's middle. In the very middle the second partial has a
    /// node, and a xylophone's twelfth would be left out.
    double offsetMetres = 0.01;

    /// Q of the first mode: 1/Q = 1/40 + (ka)²/π, losses within (a figure of ours) and radiation
    /// from an open end of radius a (Levine & Schwinger 1948).
    double qualityFactor() const;
    /// Volume flow at resonance over that of the bar above the mouth: the pressure of a piston of
    /// the mouth's size, ρωv 8a/3π, over the tube's input resistance there, ρc π/4Q.
    double amplification() const;
};

/// Adds to each mode what the tube radiates, a monopole of the volume flow
///
///     S a |H(f)| v,   H(f) = Σ_{n odd} 1/n / (1 + 2iQ (f/(n f0) − 1)),
///
/// with S the mouth, a the amplification and v the bar's velocity above it, and to its decay what
/// that takes from it: Δα = ρ ω² (S a |H| φ)² / 8πc (radiated power over twice the energy). The
/// object is a tuned bar, with shapes along the middle of its top, and has radiation weights, which
/// are means over `surfaceAreaM2`.
void addResonator(ModalObject& object, const Resonator& resonator, double surfaceAreaM2);

/// The tube's length in metres, from the closed end to the mouth: c/4f − 0.61 r.
double tubeLengthMetres(const Resonator& resonator);

} // namespace idiophone
