// The click of a rigid body: the sound of its acceleration when it is struck (acceleration noise,
// Chadwick, Zheng & James 2012). It is the response of the rigid-body modes, which objects do not
// store.
#pragma once

#include "Object/ModalObject.h"

#include <array>

namespace idiophone {

/// A rigid body as a source of sound. Rotation about the centre of mass is ignored, because it
/// displaces no net volume of air.
struct RigidRadiator {
    double massKg = 0; ///< 0: no click
    /// [3,3] symmetric: displaced volume V plus the volume of the air that moves along [m³]. An
    /// acceleration a exerts the force ρ0 · volumes · a on the air.
    std::array<double, 9> volumes{};
};

/// Returns the radiator of an object at its reference size. V is mass/density. The air that moves
/// along is approximated by that of the ellipsoid with the object's moments of inertia (Lamb,
/// Hydrodynamics, section 114). This is exact for spheres: V/2. An object without six rigid-body
/// modes in its analysis is held or measured, and does not click. Neither allocates nor throws.
RigidRadiator rigidRadiator(const ModalObject& object) noexcept;

/// Returns the length of the click of a contact of T = `contactSeconds` ≥ 0: √(T² + (3.72 a/c)²).
/// Here a is the radius of the sphere with the same volumes along the impulse. The spectrum of a
/// sine of length 3.72 a/c peaks at ka = √2, as a sphere's response to an impulse does. Any thread.
double clickSeconds(const RigidRadiator& body,
                    const std::array<float, 3>& impulseNewtonSeconds,
                    double contactSeconds,
                    double sizeRatio) noexcept;

/// Returns the amplitude P [Pa·m] of the far pressure times the distance, for a click of length
/// `seconds` > 0. `towards` is the direction, of length 1. The force on the air is a dipole, p r =
/// ρ0/(4π c) towards · volumes · da/dt (Landau & Lifshitz, Fluid Mechanics, section 74), with a =
/// (J/(M T))(1 − cos Ωt), Ω = 2π/T. So p r = P sin Ωt for 0 ≤ t ≤ T, and 0 outside. Any thread.
double clickPascalMetres(const RigidRadiator& body,
                         const std::array<float, 3>& impulseNewtonSeconds,
                         const std::array<float, 3>& towards,
                         double seconds) noexcept;

/// A click p r = P sin Ωt for 0 ≤ t ≤ T, Ω = 2π/T.
struct RigidClick {
    double seconds = 1;                   ///< T
    std::array<double, 2> pascalMetres{}; ///< P to the left and to the right
};

/// Returns the click of a strike in two directions of length 1, at least 4 samples long. The body's
/// size does not change P, because its volumes scale with its mass. Any thread.
RigidClick rigidClick(const RigidRadiator& body,
                      const std::array<float, 3>& impulseNewtonSeconds,
                      double contactSeconds,
                      double sizeRatio,
                      double sampleRateHz,
                      const std::array<std::array<float, 3>, 2>& towards) noexcept;

} // namespace idiophone
