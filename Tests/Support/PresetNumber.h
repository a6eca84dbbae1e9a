// Finds factory presets by name.
#pragma once

#include "Instrument/FactoryContent.h"

#include <algorithm>
#include <catch2/catch_test_macros.hpp>
#include <string_view>

namespace idiophone::test {

/// Returns the index in `factoryPresets`, which is also the number of the host's program.
inline int presetNumber(std::string_view name) {
    const auto presets = factoryPresets();
    const auto found = std::ranges::find(presets, name, &Preset::name);
    REQUIRE(found != presets.end());
    return static_cast<int>(found - presets.begin());
}

} // namespace idiophone::test
