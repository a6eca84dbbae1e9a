// The click of a rigid body: what its acceleration radiates when it is struck (acceleration noise,
// Chadwick, Zheng & James 2012). It is the share of the mode of frequency 0, which objects do not
// store among their modes.
#pragma once

#include "Object/ModalObject.h"

#include <array>

namespace idiophone {

/// A rigid body as a source of sound. Its rotation about the centre of mass moves no air as a
/// whole, so it does not count.
struct RigidRadiator {
    double massKg = 0; ///< 0: nothing clicks
    /// [3,3] symmetric: displaced volume V plus that of the air that moves along [m³]. An
    /// acceleration a pushes the air around with the force ρ0 · volumes · a.
    std::array<double, 9> volumes{};
};

/// Returns the radiator of an object at its reference size. V is mass/density. The air that moves
/// along is that of the ellipsoid with the object's moments of inertia (Lamb, Hydrodynamics,
/// section 114), which is exact for spheres: V/2. An object whose analysis left out no six
/// rigid-body modes is held, or was measured, and does not click. Neither allocates nor throws.
RigidRadiator rigidRadiator(const ModalObject& object) noexcept;

/// Returns the length of the click of a contact of T = `contactSeconds` ≥ 0: √(T² + (3.72 a/c)²),
/// where a is the radius of the sphere with the same volumes along the impulse. A sine of length
/// 3.72 a/c has the maximum of its spectrum where a sphere's answer to an impulse has it, at
/// ka = √2. Any thread.
double clickSeconds(const RigidRadiator& body,
                    const std::array<float, 3>& impulseNewtonSeconds,
                    double contactSeconds,
                    double sizeRatio) noexcept;

/// Returns the amplitude P [Pa·m] of the far pressure times the distance, in the direction
/// `towards` (of length 1), of a click that lasts `seconds` > 0. The force on the air is that of a
/// dipole, p r = ρ0/(4π c) towards · volumes · da/dt (Landau & Lifshitz, Fluid Mechanics, section
/// 74), and a = (J/(M T))(1 − cos Ωt), Ω = 2π/T. So p r = P sin Ωt for 0 ≤ t ≤ T and nothing else.
/// Any thread.
double clickPascalMetres(const RigidRadiator& body,
                         const std::array<float, 3>& impulseNewtonSeconds,
                         const std::array<float, 3>& towards,
                         double seconds) noexcept;

/// A click p r = P sin Ωt for 0 ≤ t ≤ T, Ω = 2π/T.
struct RigidClick {
    double seconds = 1;                   ///< T
    std::array<double, 2> pascalMetres{}; ///< P to the left and to the right
};

/// Returns the click of a strike, towards two directions of length 1, at least 4 samples long. The
/// body's size does not change P, as its volumes go with its mass. Any thread.
RigidClick rigidClick(const RigidRadiator& body,
                      const std::array<float, 3>& impulseNewtonSeconds,
                      double contactSeconds,
                      double sizeRatio,
                      double sampleRateHz,
                      const std::array<std::array<float, 3>, 2>& towards) noexcept;

} // namespace idiophone
