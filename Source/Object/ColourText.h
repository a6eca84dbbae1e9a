// Colours as the lists of Resources have them: "#rrggbb". Internal to Object.
#pragma once

#include <cstdint>
#include <string>

namespace idiophone {

/// 0xRRGGBB. Throws what std::stoul does.
inline std::uint32_t parseColour(const std::string& text) {
    return static_cast<std::uint32_t>(std::stoul(text.substr(1), nullptr, 16));
}

} // namespace idiophone
