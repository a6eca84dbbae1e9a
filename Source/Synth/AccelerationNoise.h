// SPDX-License-Identifier: Apache-2.0
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

/// A click p r = P sin Ωt for 0 ≤ t ≤ T, Ω = 2π/T.
struct RigidClick {
    double seconds = 1;                   ///< T
    std::array<double, 2> pascalMetres{}; ///< P to the left and to the right
};

/// Returns the click of a contact in two directions of length 1. Any thread.
///
/// T is √(`contactSeconds`² + (3.72 a/c)²) and at least 4 samples. Here a is the radius of the
/// sphere with the same volumes along the impulse J. The spectrum of a sine of length 3.72 a/c
/// peaks at ka = √2, as a sphere's response to an impulse does.
///
/// The force on the air is a dipole, p r = ρ0/(4π c) towards · volumes · da/dt (Landau & Lifshitz,
/// Fluid Mechanics, section 74), with a = (J/(M T))(1 − cos Ωt). The body's size does not change P,
/// as its volumes scale with its mass.
RigidClick rigidClick(const RigidRadiator& body,
                      const std::array<float, 3>& impulseNewtonSeconds,
                      double contactSeconds,
                      double sizeRatio,
                      double sampleRateHz,
                      const std::array<std::array<float, 3>, 2>& towards) noexcept;

} // namespace idiophone
