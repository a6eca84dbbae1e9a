// The click of a rigid body: what its acceleration radiates while a contact lasts (acceleration
// noise, Chadwick, Zheng & James 2012), for bodies small against the wavelengths of the pulse.
#pragma once

#include <numbers>

namespace idiophone {

/// A rigid body as a source. Its rotation about the centre of mass moves no air as a whole, so it
/// does not count.
struct RigidRadiator {
    double massKg = 0;                 ///< > 0
    double volumeCubicMetres = 0;      ///< displaced
    double addedVolumeCubicMetres = 0; ///< added mass of the air along the impulse, over ρ0
};

/// The amplitude P [Pa·m] of the far pressure times the distance in the direction of the impulse,
/// of a raised-cosine contact of that length > 0. The force on the air is that of a dipole,
/// p r = ρ0 (V + V_added)/(4π c) da/dt cos θ (Landau & Lifshitz, Fluid Mechanics, section 74), and
/// a = (J/(M T))(1 − cos Ωt), Ω = 2π/T. So p r = P cos θ sin Ωt for 0 ≤ t ≤ T and nothing else.
/// A sphere has V + V_added = 2π a³. Any thread; neither allocates nor throws.
inline double clickPascalMetres(const RigidRadiator& body,
                                double impulseNewtonSeconds,
                                double contactSeconds) noexcept {
    constexpr double airDensityKgPerM3 = 1.2, soundMetresPerSecond = 343;
    const double accelerationRate = impulseNewtonSeconds / body.massKg * 2 * std::numbers::pi /
                                    (contactSeconds * contactSeconds);
    return airDensityKgPerM3 / (4 * std::numbers::pi * soundMetresPerSecond) *
           (body.volumeCubicMetres + body.addedVolumeCubicMetres) * accelerationRate;
}

} // namespace idiophone
