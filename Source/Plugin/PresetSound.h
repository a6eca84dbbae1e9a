// Makes the sound of a preset, and the stored values of a sound.
#pragma once

#include "Plugin/Sound.h"

#include <cstdint>
#include <memory>
#include <string>

namespace idiophone {

/// Returns the sound of a preset on the shelf; `content` is the hash of its file.
Sound soundWith(Preset preset,
                std::shared_ptr<const Instrument> instrument,
                std::string id,
                std::uint64_t content = 0);

/// Stores values so that the preset is as loud as now, although "match loudness" then takes the
/// stored material and mallet as the reference. If no level is high enough, stores the present
/// reference too.
void storeValues(const Sound& sound, Preset& preset);

} // namespace idiophone
