// The air in a hollow body with one opening: it bounces in the opening like a mass on a spring
// (Helmholtz). Body and air are coupled oscillators, as a bar and its tube are.
#pragma once

#include "Analysis/Tube.h"

#include <complex>
#include <span>

namespace idiophone {

struct Cavity {
    double volumeM3 = 0;
    double mouthM2 = 0;
    double mouthLengthMetres = 0; ///< the longer side of the mouth
    double wallMetres = 0;        ///< thickness of the wall around the mouth

    /// Returns K of ω = c √(K/V), in metres: the mouth is an ellipse of this area and length in a
    /// wall of this thickness (Rayleigh, Theory of Sound, §306).
    double conductivityMetres() const;
    double frequencyHz() const;
    /// Returns the resonance. The loss is the radiation of a small mouth, ρc k²/4π, and friction on
    /// the walls of the mouth as in a tube.
    TubeResonance resonance() const;
    /// Returns pressure over flow at the mouth, in Pa s/m³.
    std::complex<double> impedancePaSPerM3(double frequencyHz) const;
};

/// Couples the air to a body, as `addTube` does for a bar. `inwardM3` [M] is the volume that each
/// mode takes from the cavity per unit of modal displacement. It compresses the air, which drives
/// the mouth as a pressure of ρc²/V · `inwardM3` would. The object's radiation is that of the body
/// with its mouth closed. `mouthMetres` is the mouth's middle from the centre of mass.
void addCavity(ModalObject& body,
               const Cavity& cavity,
               std::span<const double> inwardM3,
               const std::array<double, 3>& mouthMetres);

} // namespace idiophone
