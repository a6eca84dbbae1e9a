// SPDX-License-Identifier: Apache-2.0
// Parses the colours in the lists of mallets and materials: "#6b3324". Internal to Object.
#pragma once

#include <charconv>
#include <cstdint>
#include <optional>
#include <string_view>
#include <system_error>

namespace idiophone {

/// Returns 0xRRGGBB, or nothing if the text is not '#' and six hexadecimal digits.
inline std::optional<std::uint32_t> parseColour(std::string_view text) {
    std::uint32_t colour = 0;
    if (text.size() != 7 || text.front() != '#')
        return std::nullopt;
    const auto [end, fault] = std::from_chars(text.data() + 1, text.data() + 7, colour, 16);
    if (fault != std::errc() || end != text.data() + 7)
        return std::nullopt;
    return colour;
}

} // namespace idiophone
