// The factory's presets as the host's programs and on the shelf.
#pragma once

#include <string>

namespace idiophone {

/// By which the shelf knows the factory's preset of that name.
std::string factoryPresetId(const std::string& name);

/// Index into factoryPresets(); −1 where the id is none of theirs.
int factoryProgram(const std::string& presetId);

} // namespace idiophone
