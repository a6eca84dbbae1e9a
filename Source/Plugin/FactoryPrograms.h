// Maps the factory presets to the host's programs and to ids on the shelf.
#pragma once

#include <string>

namespace idiophone {

/// Returns the shelf's id of the factory preset of that name.
std::string factoryPresetId(const std::string& name);

/// Returns the index into factoryPresets(), or −1 if the id is not a factory preset's.
int factoryProgram(const std::string& presetId);

} // namespace idiophone
