// The factory's instruments that are not bars: plates, rings, bowls, bells and tubes, from
// generated meshes. docs/instruments.md has their measures and where these come from.
#pragma once

#include "Analysis/AnalysisControl.h"
#include "Object/ModalObject.h"

#include <string>
#include <vector>

namespace idiophone {

inline constexpr int lowestTubularBell = 60, highestTubularBell = 77; ///< MIDI, as they are written

/// "plate", "ring", "handbell", "glass-bowl", "wok", "table", "shell-case", and "tubular-bell-60"
/// to "tubular-bell-77".
std::vector<std::string> factoryShapeNames();

/// Analyses one of them, in seconds. Errors: an unknown name, or `cancelledMessage`.
Result<ModalObject> makeFactoryShape(const std::string& name, const AnalysisControl& control = {});

} // namespace idiophone
