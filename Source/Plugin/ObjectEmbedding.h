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

/// Builds the instrument of a single object, which is not null: the map's, whose kind is not
/// `bars`.
Result<std::shared_ptr<const Instrument>>
buildSingleObject(const KeyMap& keyMap, const std::shared_ptr<const ModalObject>& object);

/// Builds an instrument of the same objects as another: the map differs in how keys play them, not
/// in which there are.
Result<std::shared_ptr<const Instrument>> rebuilt(const Instrument& from, const KeyMap& keyMap);

} // namespace idiophone
