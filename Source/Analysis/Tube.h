// The tube under a bar: closed below, a quarter of a wave long. Bar and tube are coupled
// oscillators, which share the modes near the tube's resonances.
#pragma once

#include "Object/ModalObject.h"

#include <array>
#include <complex>
#include <span>

namespace idiophone {

/// One resonance of a tube, seen from its mouth as mass, damping and spring of the air that moves
/// through it.
struct TubeResonance {
    double omega = 0;            ///< undamped, rad/s
    double decayPerSecond = 0;   ///< by the wall and by what the mouth radiates
    double inertanceKgPerM4 = 0; ///< M_a = ρ0 L/(2S): half of the air's, as in any standing wave
};

struct Tube {
    double frequencyHz = 440;   ///< of its first mode; it has the odd multiples too
    double radiusMetres = 0.02; ///< of its mouth
    /// By which the mouth stands off the bar's middle. In the very middle the second partial has a
    /// node, and a xylophone's twelfth would be left out.
    double offsetMetres = 0.01;
    double gapMetres = 0.02; ///< from the bar's ends, at their lowest, down to the mouth

    double mouthM2() const;
    /// c/4f, with the air that moves before the mouth.
    double acousticLengthMetres() const;

    /// What the air in the tube opposes to a pressure at the mouth, over ρ0 c/S:
    ///
    ///     z = coth((α + jk) c/4f0) + (ka)²/4,   α = 3·10⁻⁵ √f/a,
    ///
    /// losses at the wall (Fletcher & Rossing 1998, section 8.2) and radiation from an open end of
    /// radius a (Levine & Schwinger 1948; at most 1).
    std::complex<double> relativeImpedance(double frequencyHz) const;

    /// That at the frequency (2n + 1) f0, n ≥ 0.
    TubeResonance resonance(int n) const;
};

/// The tube's length in metres, from the closed end to the mouth: c/4f − 0.61 r.
double tubeLengthMetres(const Tube& tube);

/// A mode that a bar and a tube share, e^{pole·t}.
struct SharedMode {
    std::complex<double> pole; ///< [1/s], imaginary part > 0
    /// What the bar's modal velocity takes from a modal impulse of 1, over what a mode of that pole
    /// takes alone.
    std::complex<double> gain;
    /// The volume velocity into the tube of the same impulse, over the same [m³/s].
    std::complex<double> flow;
};

/// The two modes of a bar's mode (undamped ω, decay) over a tube's resonance. `mouthKgPerM2` is the
/// blocked pressure at the mouth over the modal acceleration. By reciprocity it also pushes the
/// bar:
///
///     q̈ + 2α q̇ + ω² q = F + p V̈,   M_a (V̈ + 2α_t V̇ + ω_t² V) = p q̈,
///
/// with V the volume that has moved into the tube and p = `mouthKgPerM2`. The modes are those of
/// this quadratic eigenproblem. In the order of rising frequency, then decay.
std::array<SharedMode, 2> sharedModes(double barOmega,
                                      double barDecayPerSecond,
                                      const TubeResonance& tube,
                                      double mouthKgPerM2);

/// Puts the tube under the bar. Each resonance in the band shares the mode that it couples to most,
/// if that lies within a whole tone: the object has two modes of that shape then, with gains. A pair
/// of which one has a gain below 0.001 hardly differs from the bar's own mode, which stays. All
/// other modes drive the tube as it is at their frequency, which costs them decay. What flows
/// through the mouth radiates as a monopole there. Like the bar's own, the tube's poles keep their
/// ratio to the fundamental when size or material change: it is cut anew for the bar.
///
/// `mouthKgPerM2` [M] is the blocked pressure at the mouth over the acceleration of each mode, and
/// `mouthMetres` the mouth's place from the centre of mass. The object has radiation.
void addTube(ModalObject& bar,
             const Tube& tube,
             std::span<const double> mouthKgPerM2,
             const std::array<double, 3>& mouthMetres);

} // namespace idiophone
