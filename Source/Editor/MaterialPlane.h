// The map of materials: from slow to fast sound, from dull to ringing, with mixtures between the
// named ones. Mathematics only; MaterialPad draws it.
#pragma once

#include "Object/Material.h"

#include <span>

namespace idiophone {

/// A place on the map; both coordinates are from 0 to 1.
struct PlanePlace {
    double fast = 0;    ///< speed of sound √(Y/ρ), logarithmic; pitch rises with it
    double ringing = 0; ///< decay time of a mode at 1 kHz, logarithmic
};

/// Values at the ends of the map.
inline constexpr double slowestMetresPerSecond = 700, fastestMetresPerSecond = 7000;
inline constexpr double dullestSeconds = 0.03, longestRingSeconds = 200;
inline constexpr double planeFrequencyHz = 1000;

/// Clamped to the map.
PlanePlace placeOf(const Material& material);

double soundMetresPerSecond(const PlanePlace& place);
double decaySecondsAt(const PlanePlace& place);

/// The material at a place. Density and the mix of damping kinds are averages over `known`,
/// weighted with the inverse square of the distance on the map, so that named materials keep their
/// own values. Young's modulus and the amount of damping are then solved for the place. `known` is
/// not empty.
Material materialAt(const PlanePlace& place, std::span<const Material> known);

} // namespace idiophone
