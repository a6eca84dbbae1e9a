// Packs modal objects that are not part of the program into states, and builds instruments from
// them.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/Preset.h"
#include "Plugin/State.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// An object of an instrument that came from a file; never null.
struct ForeignObject {
    std::string name; ///< as the key map names it
    std::shared_ptr<const ModalObject> object;
};

/// Returns each foreign object once, in the order of the keys.
std::vector<ForeignObject> foreignObjects(const Instrument& instrument);

/// Encodes an object as a .modal file, with shapes in half precision if that loses nothing.
std::vector<std::byte> modalFile(const ModalObject& object);

/// Returns the foreign objects packed for a state. Each object is packed once per process, or never
/// if it came from a state, and the text is kept while the object lives.
std::vector<EmbeddedObject> embeddedObjects(const Instrument& instrument);

/// Builds the instrument with the given objects under their names. Factory objects keep their names
/// even if an embedded object has the same one. Other instances do not see the objects. Refuses an
/// instrument too large for a state, as `buildSingleObject` does.
Result<std::shared_ptr<const Instrument>>
buildInstrument(const KeyMap& keyMap, const std::vector<EmbeddedObject>& objects);

/// Returns the instrument, or an error if its objects are too large for a state.
Result<std::shared_ptr<const Instrument>> fitForState(std::shared_ptr<const Instrument> instrument);

/// Returns the name of the first missing object: not a factory object, not given and not a file.
/// For a scene, returns the scene or the first missing file that it names. Shortens a long name to
/// its end.
std::optional<std::string> firstMissing(const KeyMap& keyMap,
                                        const std::vector<EmbeddedObject>& objects);

/// Returns a key map that plays the factory's ring at the pitches of the keys.
KeyMap standInFor(const KeyMap& keyMap);

/// Objects that a state names and this machine lacks, while a stand-in plays. They are saved again,
/// so that the sound is complete once the objects are back.
struct MissingObjects {
    std::string first; ///< from `firstMissing`
    KeyMap keyMap;
    ModeSet mutedModes;
    std::vector<EmbeddedObject> objects; ///< the other objects of the state
};

/// If a state's preset lacks an object, replaces its key map by the stand-in's and returns the
/// original. Otherwise returns null.
std::shared_ptr<const MissingObjects> replaceMissing(Preset& preset,
                                                     const std::vector<EmbeddedObject>& objects);

/// Builds the instrument of a single object, not null, under the map's name. The map's kind is not
/// `bars`.
Result<std::shared_ptr<const Instrument>>
buildSingleObject(const KeyMap& keyMap, const std::shared_ptr<const ModalObject>& object);

/// Builds an instrument of the same objects as `from`. The map may change how keys play the
/// objects, but not the set of objects.
Result<std::shared_ptr<const Instrument>> rebuilt(const Instrument& from, const KeyMap& keyMap);

} // namespace idiophone
