// Makes a ball that moves only as a rigid body: its one mode has no amplitude.
#pragma once

#include "Support/SyntheticObject.h"

namespace idiophone::test {

/// The left direction is straight above, and the right one 60° from it.
inline ModalObject rigidBall(double radiusMetres, double densityKgPerM3) {
    auto object = syntheticObject({3170}, {0.0f});
    object.body = BodyKind::solid;
    object.thicknessMetres = 0;
    object.material.densityKgPerM3 = densityKgPerM3;
    const double massKg = 4 * std::numbers::pi / 3 * std::pow(radiusMetres, 3) * densityKgPerM3;
    const double inertia = 0.4 * massKg * radiusMetres * radiusMetres;
    object.mass = {.massKg = massKg, .inertiaKgM2 = {inertia, 0, 0, 0, inertia, 0, 0, 0, inertia}};
    object.provenance.zeroModes = 6;
    object.radiation = {.directions = {{0, 0, 1}, {std::sqrt(0.75f), 0, 0.5f}},
                        .frequencyRatios = {1},
                        .weights = {0.0f, 0.0f}};
    return object;
}

} // namespace idiophone::test
