// The plain preset to start from.
#pragma once

#include "Instrument/Preset.h"

namespace idiophone {

/// Returns "Init": the factory's rosewood bars struck in the middle, as loud as the factory
/// presets. All parameters except the level have their defaults.
Preset initialPreset();

} // namespace idiophone
