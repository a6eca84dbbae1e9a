// The factory presets whose keys play objects, without those of scenes.
#pragma once

#include "Instrument/FactoryContent.h"

#include <algorithm>
#include <span>

namespace idiophone::test {

/// Those of scenes stand behind them.
inline std::span<const Preset> keyedFactoryPresets() {
    const auto all = factoryPresets();
    const auto scenes = std::ranges::find_if(
        all, [](const Preset& preset) { return preset.keyMap.kind == KeyMapKind::scene; });
    return all.first(static_cast<std::size_t>(scenes - all.begin()));
}

} // namespace idiophone::test
