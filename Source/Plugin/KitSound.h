// Puts an object on one key of the sound that plays, which becomes a kit.
#pragma once

#include "Plugin/Sound.h"

#include <memory>
#include <string>

namespace idiophone {

/// Returns the sound `before` with an object on a key, 0 to 127, as loud as factory presets are. It
/// sounds besides what the key played, unless that was an object for this key alone, which it
/// replaces. `objectName` is unique among all objects. Fails on a stage, for a missing object, and
/// if two parts play the key already. Not for the audio thread.
Result<Sound> withObjectOnKey(const Sound& before,
                              int midiNote,
                              const std::shared_ptr<const ModalObject>& object,
                              const std::string& objectName,
                              double sampleRateHz);

} // namespace idiophone
