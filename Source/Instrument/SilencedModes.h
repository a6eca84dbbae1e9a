// The modes of an instrument's objects that are silenced, in the form that synthesis takes.
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
        const ModalObject* object = nullptr;  ///< compared as an address only
        std::vector<std::uint8_t> isSilenced; ///< [M] 0 or 1
    };
    std::vector<OfObject> objects; ///< objects without an entry have no silenced modes
};

/// Returns the key by which mode sets identify the object of a slot. This is the lowest note that
/// plays the object if each note has an object. It is the object's name on a stage, otherwise
/// "all". Outside a stage the name is not used, because files may be renamed and finished analyses
/// replace previews. Any thread except the audio thread.
std::string modeSetKey(const Instrument& instrument, std::size_t slot);

/// Returns the muted modes of every object. If an object has soloed modes, returns all its other
/// modes, muted or not. Ignores modes and objects that the instrument lacks. Any thread except the
/// audio thread.
SilencedModes
silencedModes(const Instrument& instrument, const ModeSet& muted, const ModeSet& heardAlone);

} // namespace idiophone
