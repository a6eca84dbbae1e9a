// Finds a preset by its factory name or reads it from a file.
#pragma once

#include "Instrument/Preset.h"

#include <string>

namespace idiophone {

/// Returns the factory preset of that name, or else the preset in the file of that path with its
/// objects (withObjectsBeside). An empty text gives the default preset without objects. Warns on
/// standard error of parameters that this version does not know.
Result<Preset> findOrReadPreset(const std::string& nameOrFile);

} // namespace idiophone
