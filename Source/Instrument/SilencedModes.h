// Which modes of an instrument's objects are not to be heard, as synthesis takes it: plain data.
#pragma once

#include "Object/ModalObject.h"

#include <cstdint>
#include <vector>

namespace idiophone {

struct SilencedModes {
    struct OfObject {
        const ModalObject* object = nullptr;  ///< compared, never read
        std::vector<std::uint8_t> isSilenced; ///< [M] 0 or 1
    };
    std::vector<OfObject> objects; ///< of all others nothing is silenced
};

} // namespace idiophone
