// How names that people type are compared.
#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace idiophone {

/// Whether two names differ at most in the case of their ASCII letters.
inline bool sameName(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

} // namespace idiophone
