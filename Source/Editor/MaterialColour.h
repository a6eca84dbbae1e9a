// The colour in which a material is drawn.
#pragma once

#include "Object/Material.h"

#include <array>
#include <cstdint>

namespace idiophone {

/// Red, green and blue, 0 to 1. Materials of the library have a fixed colour. Other materials get
/// one by kind: wood has a grain, metals are heavy, stone, glass and ceramics are stiff, and
/// plastics are neither.
inline std::array<float, 3> colourOf(const Material& material) {
    constexpr std::uint32_t wood = 0x996b45, metal = 0x9ea6b0, stone = 0xa8adb0, plastic = 0x4c8c99;
    const auto guessed = material.grain                    ? wood
                         : material.densityKgPerM3 > 4500  ? metal
                         : material.youngsModulusPa > 2e10 ? stone
                                                           : plastic;
    const auto colour = materialColour(material.name).value_or(guessed);
    const auto channel = [&](int shift) {
        return static_cast<float>((colour >> shift) & 0xff) / 255;
    };
    return {channel(16), channel(8), channel(0)};
}

} // namespace idiophone
