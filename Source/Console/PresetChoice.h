// A preset by its factory name or from a file.
#pragma once

#include "Instrument/Preset.h"

#include <string>

namespace idiophone {

/// The factory preset of that name, or else the preset in the file of that path with
/// its objects (withObjectsBeside); an empty text is a
/// preset of defaults without objects. Warns on standard error of parameters that this version does
/// not know.
Result<Preset> findOrReadPreset(const std::string& nameOrFile);

} // namespace idiophone
