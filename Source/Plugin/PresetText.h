// The JSON of presets that are written again, with what this version does not know of them.
#pragma once

#include "Instrument/Preset.h"

#include <string>
#include <string_view>

namespace idiophone {

/// The preset's JSON with another name, all else and its order as before. The error is what is
/// wrong, to be put after the file's name.
Result<std::string> renamedPreset(std::string_view text, const std::string& name);

/// The preset's JSON with what this version does not know of the one `before`, as long as both
/// together are not too large for a preset.
std::string presetInPlaceOf(std::string_view before, const Preset& preset);

} // namespace idiophone
