// Which modes of an instrument's objects are not to be heard, as synthesis takes it.
#pragma once

#include "Instrument/Instrument.h"
#include "Instrument/ModeSet.h"

#include <cstddef>
#include <cstdint>
#include <string>
#include <vector>

namespace idiophone {

struct SilencedModes {
    struct OfObject {
        const ModalObject* object = nullptr;  ///< compared, never read
        std::vector<std::uint8_t> isSilenced; ///< [M] 0 or 1
    };
    std::vector<OfObject> objects; ///< of all others nothing is silenced
};

/// By what mode sets know the object of a slot: the lowest note that plays it where there is one
/// object a key, the object's name on a stage, else "all". Where it can be it is not the name, for
/// files of objects may be renamed, and finished analyses take the place of previews. For any
/// thread but audio.
std::string modeSetKey(const Instrument& instrument, std::size_t slot);

/// [any thread but audio] Of every object the muted modes; of one with modes heard alone all
/// others, muted or not. Modes and objects that the instrument does not have are passed over.
SilencedModes
silencedModes(const Instrument& instrument, const ModeSet& muted, const ModeSet& heardAlone);

} // namespace idiophone
