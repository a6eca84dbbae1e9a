// Reads and writes key maps as JSON; presets contain them. docs/presets.md specifies them.
#pragma once

#include "Instrument/KeyMap.h"

#include <string>

namespace idiophone {

class JsonPlace;

/// Reads and validates a key map. An error throws JsonPlace::Fault. Not for the audio thread.
KeyMap keyMapAt(const JsonPlace& place);

/// Returns the word for a kind in files.
const char* kindName(KeyMapKind kind);

/// Returns the key map as JSON text that `keyMapAt` reads back to an equal map.
std::string encodeKeyMap(const KeyMap& map);

} // namespace idiophone
