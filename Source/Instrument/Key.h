// A key of an instrument: what one MIDI note strikes, and how.
#pragma once

#include "Instrument/KeyMallet.h"
#include "Instrument/KeyMap.h"
#include "Instrument/StrikeStrip.h"

#include <memory>

namespace idiophone {

/// The object, place and mallet of a MIDI note; in a kit, of one of its parts.
struct Key {
    int slot = -1;                            ///< −1: the note is silent
    std::shared_ptr<const StrikeStrip> strip; ///< the object's; null if the note is silent
    double along = 0.5;                       ///< place on the strip, 0 to 1
    KeyMallet mallet = {};                    ///< difference from the chosen mallet
    /// False if the preset has no object for the key, so that the key plays a neighbour's.
    bool isOwn = true;
    const KitPart* part = nullptr; ///< of the instrument's key map; null if it is no kit

    bool takes(int velocity) const noexcept {
        return part == nullptr ||
               (velocity >= part->lowestVelocity && velocity <= part->highestVelocity);
    }
};

} // namespace idiophone
