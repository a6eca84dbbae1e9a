// The part of a scene file that is a recorded hand.
#pragma once

#include "Instrument/JsonPlace.h"
#include "Scene/Scene.h"

#include <vector>

namespace idiophone {

/// Bounds of all of a scene's figures, within which single precision and the rigid bodies stay
/// well.
inline constexpr double farthestMetres = 1000;
inline constexpr double longestSeconds = 3600;

/// Which of the kinds is named there. As the next one, throws JsonPlace::Fault.
std::size_t parseKindName(const JsonPlace& place, const std::vector<BodyTemplate>& kinds);

Hand parseHand(const JsonPlace& place, const std::vector<BodyTemplate>& kinds);

} // namespace idiophone
