// Parses the part of a scene file that describes a recorded hand.
#pragma once

#include "Instrument/JsonPlace.h"
#include "Scene/Scene.h"

#include <vector>

namespace idiophone {

/// Bounds of every place and time in a scene. Single precision and the rigid bodies stay accurate
/// within them.
inline constexpr double maximumMetres = 1000;
inline constexpr double longestSeconds = 3600;

/// Returns the index of the named kind. Both functions throw JsonPlace::Fault.
std::size_t parseKindName(const JsonPlace& place, const std::vector<BodyTemplate>& kinds);

Hand parseHand(const JsonPlace& place, const std::vector<BodyTemplate>& kinds);

} // namespace idiophone
