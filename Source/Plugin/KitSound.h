// Makes a kit of the sound that plays, and changes its parts. The objects in memory are kept.
#pragma once

#include "Plugin/Sound.h"

#include <memory>
#include <string>

namespace idiophone {

/// None of these is for the audio thread. Errors are clauses for the end of a sentence: "the keys
/// play a scene".

/// Fails on a stage, and if objects are missing.
Result<void> canBeKit(const Sound& sound);

/// Returns the sound `before` as a kit of one part, which sounds the same.
Result<Sound> asKit(const Sound& before);

/// Returns the kit `before` with another part at the index, which must exist. Fails if more than
/// two parts would play a key at one velocity, or if the part's lowest key has no bar.
Result<Sound> withChangedPart(const Sound& before, std::size_t index, const KitPart& part);

/// Returns the kit `before` without the part at the index, which must exist. Fails for the last
/// one.
Result<Sound> withoutPart(const Sound& before, std::size_t index);

/// Returns the sound `before` with an object on a key, 0 to 127, as loud as factory presets are. It
/// sounds besides what the key played, unless that was an object for this key alone, which it
/// replaces. `objectName` is unique among all objects. Fails if two parts play the key already.
Result<Sound> withObjectOnKey(const Sound& before,
                              int midiNote,
                              const std::shared_ptr<const ModalObject>& object,
                              const std::string& objectName,
                              double sampleRateHz);

/// Returns the sound `before`, which plays the preview, with the whole object in its place. Parts
/// of a kit stay as loud as they were.
Result<Sound> withWholeObject(const Sound& before,
                              const std::shared_ptr<const ModalObject>& preview,
                              const std::shared_ptr<const ModalObject>& whole,
                              const std::string& wholeName,
                              double sampleRateHz);

/// Returns a map that is no kit on other keys, and on no others resized. Keys keep their place of
/// the strike and their voicing. A path of `zones` spreads over the keys.
KeyMap onKeys(const KeyMap& map, int lowestNote, int highestNote);

} // namespace idiophone
