// Describes the instrument of a page as JSON, for JavaScript.
#pragma once

#include "Browser/BrowserInstrument.h"

#include <string>

namespace idiophone {

/// None of these is for callbacks. docs/web.md specifies the texts.

/// Returns the factory presets.
std::string presetsText();
/// Returns the table of parameters.
std::string parametersText();
/// Returns what plays: its keys, objects and values. `null` before the first load.
std::string instrumentText(const BrowserInstrument& played);
/// Returns the names of the objects that a preset needs, as a list. The error names a scene that
/// does not exist.
Result<std::string> objectNamesText(const Preset& preset);

} // namespace idiophone
