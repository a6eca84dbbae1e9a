// Words as people type them.
#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace idiophone {

/// Whether two words differ at most in capital letters (of ASCII).
inline bool sameWord(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

} // namespace idiophone
