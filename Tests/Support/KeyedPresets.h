// Lists the factory presets whose keys play objects, without those of scenes.
#pragma once

#include "Instrument/FactoryContent.h"

#include <ranges>

namespace idiophone::test {

/// Returns the presets that keys play, in the order of factoryPresets().
inline auto keyedFactoryPresets() {
    return factoryPresets() | std::views::filter([](const Preset& preset) {
               return preset.keyMap.kind != KeyMapKind::scene;
           });
}

} // namespace idiophone::test
