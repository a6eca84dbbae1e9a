// SPDX-License-Identifier: Apache-2.0
// Compares names that people type.
#pragma once

#include <algorithm>
#include <cctype>
#include <string_view>

namespace idiophone {

/// Returns whether two names are equal apart from the case of ASCII letters.
inline bool sameName(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

} // namespace idiophone
