#include "Instrument/InitialPreset.h"

namespace idiophone {

Preset initialPreset() {
    Preset preset;
    preset.name = "Init";
    preset.description = "Rosewood bars with all parameters at their defaults, to start from.";
    preset.keyMap = {.kind = KeyMapKind::bars,
                     .lowestNote = 65,
                     .highestNote = 108,
                     .object = "xylophone-{note}"};
    preset.parameters.set(ParameterId::level, -8.7);
    return preset;
}

} // namespace idiophone
