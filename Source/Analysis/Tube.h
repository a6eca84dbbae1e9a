// The tube under a bar: closed below, a quarter of a wave long. Bar and tube are coupled
// oscillators and share the modes near the tube's resonances.
#pragma once

#include "Object/ModalObject.h"

#include <array>
#include <complex>
#include <functional>
#include <span>

namespace idiophone {

/// One resonance of a tube, seen from its mouth: mass, damping and spring of the moving air.
struct TubeResonance {
    double omega = 0;            ///< undamped, rad/s
    double decayPerSecond = 0;   ///< from wall losses and radiation of the mouth
    double inertanceKgPerM4 = 0; ///< M_a = ρ0 L/(2S): half of the air's, as in any standing wave
};

struct Tube {
    double frequencyHz = 440;   ///< of its first mode; the others are odd multiples
    double radiusMetres = 0.02; ///< of its mouth
    /// Distance of the mouth from the bar's middle. In the exact middle the second partial has a
    /// node, so the tube would not sound a xylophone's twelfth.
    double offsetMetres = 0.01;
    double gapMetres = 0.02; ///< from the lowest point of the bar's ends down to the mouth

    double mouthM2() const;
    /// Returns c/4f, including the end correction.
    double acousticLengthMetres() const;

    /// Returns the input impedance at the mouth, over ρ0 c/S:
    ///
    ///     z = coth((α + jk) c/4f0) + (ka)²/4,   α = 3·10⁻⁵ √f/a,
    ///
    /// with wall losses (Fletcher & Rossing 1998, section 8.2) and radiation from an open end of
    /// radius a (Levine & Schwinger 1948; at most 1).
    std::complex<double> relativeImpedance(double frequencyHz) const;

    /// Returns the resonance at the frequency (2n + 1) f0, n ≥ 0.
    TubeResonance resonance(int n) const;
};

/// Returns the length in metres from the closed end to the mouth: c/4f − 0.61 r.
double tubeLengthMetres(const Tube& tube);

/// A mode that a bar and a tube share, e^{pole·t}.
struct SharedMode {
    std::complex<double> pole; ///< [1/s], imaginary part > 0
    /// The bar's modal velocity after a modal impulse of 1, over that of a single mode with this
    /// pole.
    std::complex<double> gain;
    /// The volume velocity into the tube after a modal impulse of 1, over the same modal velocity
    /// of a single mode [m³/s].
    std::complex<double> flow;
};

/// Returns the two modes of a bar's mode (undamped ω, decay) coupled to a tube's resonance.
/// `mouthKgPerM2` is the blocked pressure at the mouth over the modal acceleration. By reciprocity
/// it also drives the bar:
///
///     q̈ + 2α q̇ + ω² q = F + p V̈,   M_a (V̈ + 2α_t V̇ + ω_t² V) = p q̈,
///
/// with V the volume displaced into the tube and p = `mouthKgPerM2`. The modes solve this quadratic
/// eigenproblem. They are sorted by rising frequency, then decay.
std::array<SharedMode, 2> sharedModes(double barOmega,
                                      double barDecayPerSecond,
                                      const TubeResonance& tube,
                                      double mouthKgPerM2);

/// The air beside a body: its resonances in the body's band, and pressure over flow at the mouth
/// for a frequency in Hz.
struct ResonantAir {
    std::span<const TubeResonance> resonances;
    std::function<std::complex<double>(double)> impedancePaSPerM3;
};

/// Adds the tube to the bar. Each resonance in the band shares the mode to which it couples most,
/// if that lies within a whole tone. Two modes with that mode's shape, and with gains, then replace
/// it. If one of them has a gain below 0.001, the bar's own mode is kept, because it hardly
/// changes. All other modes drive the tube's impedance at their frequency, which increases their
/// decay. The flow through the mouth radiates as a monopole. If size or material change, all poles
/// keep their ratio to the fundamental, as with a tube cut to fit the new bar.
///
/// `mouthKgPerM2` [M] is the blocked pressure at the mouth over the acceleration of each mode.
/// `mouthMetres` is the mouth's position from the centre of mass. The object has radiation.
void addTube(ModalObject& bar,
             const Tube& tube,
             std::span<const double> mouthKgPerM2,
             const std::array<double, 3>& mouthMetres);

/// Does the same with other air, such as a cavity's (Cavity.h).
void addResonantAir(ModalObject& body,
                    const ResonantAir& air,
                    std::span<const double> mouthKgPerM2,
                    const std::array<double, 3>& mouthMetres);

} // namespace idiophone
