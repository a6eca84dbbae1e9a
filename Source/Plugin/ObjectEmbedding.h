// Modal objects that a state must carry, as they are not part of the program, and instruments built
// from what a state carried.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/Preset.h"
#include "Plugin/State.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// An object of an instrument that came from a file; not null.
struct ForeignObject {
    std::string name; ///< by which the key map knows it
    std::shared_ptr<const ModalObject> object;
};

/// Each once, in the order of the keys.
std::vector<ForeignObject> foreignObjects(const Instrument& instrument);

/// Its .modal file, with shapes in half precision where that loses nothing.
std::vector<std::byte> modalFile(const ModalObject& object);

/// The same objects as a state carries them, packed. Each object of the process is packed once, or
/// not at all where it came from a state, for as long as it lives.
std::vector<EmbeddedObject> embeddedObjects(const Instrument& instrument);

/// Builds the instrument with the given objects under their names; factory objects keep theirs,
/// whatever is embedded under the same name, and other instances know nothing of them. Refuses an
/// instrument whose objects no state can carry, as `buildSingleObject` does.
Result<std::shared_ptr<const Instrument>>
buildInstrument(const KeyMap& keyMap, const std::vector<EmbeddedObject>& objects);

/// The instrument unless its objects are too large for a state.
Result<std::shared_ptr<const Instrument>> fitForState(std::shared_ptr<const Instrument> instrument);

/// The first object of its notes that is neither the factory's nor given nor a file; or its scene,
/// or what that names: its name for a sentence, of a long one the end.
std::optional<std::string> firstMissing(const KeyMap& keyMap,
                                        const std::vector<EmbeddedObject>& objects);

/// The factory's ring at the pitches of the keys, to play in the place of what is missing.
KeyMap standInFor(const KeyMap& keyMap);

/// What a state names and this machine lacks, while something plays in its place: saved again, so
/// that the sound is whole once it is back.
struct MissingObjects {
    std::string first; ///< as of `firstMissing`
    KeyMap keyMap;
    ModeSet mutedModes;
    std::vector<EmbeddedObject> objects; ///< those that are there
};

/// Where something is missing to a state's preset, gives it the stand-in's keys and returns what it
/// had; else nothing.
std::shared_ptr<const MissingObjects> replaceMissing(Preset& preset,
                                                     const std::vector<EmbeddedObject>& objects);

/// Builds the instrument of a single object, which is not null: the map's, whose kind is not
/// `bars`.
Result<std::shared_ptr<const Instrument>>
buildSingleObject(const KeyMap& keyMap, const std::shared_ptr<const ModalObject>& object);

/// Builds an instrument of the same objects as another: the map differs in how keys play them, not
/// in which there are.
Result<std::shared_ptr<const Instrument>> rebuilt(const Instrument& from, const KeyMap& keyMap);

} // namespace idiophone
