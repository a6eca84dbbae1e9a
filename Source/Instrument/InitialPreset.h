// The plain sound to start from.
#pragma once

#include "Instrument/Preset.h"

namespace idiophone {

/// "Init": the factory's rosewood bars struck in the middle, all parameters but the level at their
/// defaults, as loud as the factory's presets.
Preset initialPreset();

} // namespace idiophone
