// Modal objects that a state must carry, as they are not part of the program, and instruments built
// from what a state carried.
#pragma once

#include "Instrument/Instrument.h"
#include "Plugin/State.h"

#include <memory>
#include <vector>

namespace idiophone {

/// The instrument's objects that came from files, each once, in the order of the keys.
std::vector<EmbeddedObject> foreignObjects(const Instrument& instrument);

/// Builds the instrument with the given objects under their names; factory objects keep theirs,
/// whatever is embedded under the same name. May wait for another instance that does the same.
Result<std::shared_ptr<const Instrument>>
buildInstrument(const KeyMap& keyMap, const std::vector<EmbeddedObject>& objects);

} // namespace idiophone
