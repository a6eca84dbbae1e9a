// The factory presets whose keys play objects, without those of scenes.
#pragma once

#include "Instrument/FactoryContent.h"

#include <ranges>

namespace idiophone::test {

/// In their order, wherever those of scenes stand between them.
inline auto keyedFactoryPresets() {
    return factoryPresets() | std::views::filter([](const Preset& preset) {
               return preset.keyMap.kind != KeyMapKind::scene;
           });
}

} // namespace idiophone::test
