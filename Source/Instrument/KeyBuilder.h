// Makes the keys of one key map, and the slots that they play.
#pragma once

#include "Instrument/Key.h"
#include "Instrument/ObjectSource.h"
#include "Synth/Synthesiser.h"

#include <array>
#include <bitset>
#include <map>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace idiophone {

/// Makes each object's strip once: several keys may share a large one. The map must outlive it.
class StripsOfObjects {
public:
    explicit StripsOfObjects(const KeyMap& keyMap) : map(keyMap) {}
    std::shared_ptr<const StrikeStrip> of(const ModalObject& object);

private:
    const KeyMap& map;
    std::map<const ModalObject*, std::shared_ptr<const StrikeStrip>> strips;
};

struct BuiltKeys {
    std::array<Key, 128> keys;
    std::vector<SynthesiserSlot> slots;
    std::vector<std::string> names; ///< [slots] of the objects, as the map names them
};

/// Loads the objects of a map of kind `bars`, `zones` or `scaled`, and voices the keys. The error
/// names the object at fault. Not for the audio thread.
Result<BuiltKeys> buildKeys(const KeyMap& map, ObjectSource& objects);

/// Lets keys without an object play the nearest of the map's own keys, resized to their pitch; keys
/// outside the map's own only if they are `free`. Does nothing for `zones`, or if the slots would
/// then have more than `maximumModes` modes.
void addResizedKeys(BuiltKeys& built,
                    const KeyMap& map,
                    const std::bitset<128>& free,
                    std::size_t maximumModes);

/// Returns the modes of all slots together.
std::size_t modesOf(std::span<const SynthesiserSlot> slots);

} // namespace idiophone
