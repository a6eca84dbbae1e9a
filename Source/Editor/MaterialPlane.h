// A map of materials: from slow to fast sound, from dull to ringing. Between the named materials
// lie mixtures of them. Plain mathematics; drawing it is MaterialPad's.
#pragma once

#include "Object/Material.h"

#include <span>

namespace idiophone {

/// A place on the map, both from 0 to 1.
struct PlanePlace {
    double fast = 0;    ///< the speed of sound √(Y/ρ), logarithmic: pitch rises with it
    double ringing = 0; ///< the decay time of a mode at 1 kHz, logarithmic
};

/// What the ends of the map mean.
inline constexpr double slowestMetresPerSecond = 700, fastestMetresPerSecond = 7000;
inline constexpr double dullestSeconds = 0.03, longestRingSeconds = 200;
inline constexpr double planeFrequencyHz = 1000;

/// Clamped to the map.
PlanePlace placeOf(const Material& material);

double soundMetresPerSecond(const PlanePlace& place);
double decaySecondsAt(const PlanePlace& place);

/// The material at a place: density and the kind of damping are those of the materials around it,
/// weighted with the inverse square of their distance on the map, so that at a named material's
/// place it is that material's. Young's modulus and the amount of damping are then such that it
/// lies exactly there. `known` is not empty.
Material materialAt(const PlanePlace& place, std::span<const Material> known);

} // namespace idiophone
