// Makes the sound of an object from the workshop: its keys, its mallet and its level.
#pragma once

#include "Editor/WorkshopView.h"
#include "Plugin/ObjectWorkshop.h"
#include "Plugin/Sound.h"

#include <memory>
#include <optional>

namespace idiophone {

/// Returns the sound of a product that replaces `before`. The first product of a new file gets keys
/// at its pitches, an audible mallet and a usual level; others are as loud as `before`.
Result<Sound>
soundOf(const ObjectWorkshop::Product& product, const Sound& before, double sampleRateHz);

/// Returns `sound` at the level that matches the loudness of the sound `before` and keeps its
/// headroom.
Sound asLoudAs(const Sound& before, Sound sound, double sampleRateHz);

/// Returns the first slot of an object; nothing if the instrument, which may be null, has it not.
std::optional<std::size_t> slotOf(const std::shared_ptr<const Instrument>& instrument,
                                  const ModalObject& object);

/// Returns whether this is one of the instrument's objects.
bool plays(const std::shared_ptr<const Instrument>& instrument, const ModalObject& object);

/// Returns nothing if each key has an object of its own.
std::optional<KeyLayout> layoutOf(const std::shared_ptr<const Instrument>& instrument);

} // namespace idiophone
