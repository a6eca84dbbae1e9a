// SPDX-License-Identifier: Apache-2.0
// The mark that some editors put before UTF-8 text.
#pragma once

#include <string_view>

namespace idiophone {

inline std::string_view withoutByteOrderMark(std::string_view text) {
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    return text.starts_with(mark) ? text.substr(mark.size()) : text;
}

} // namespace idiophone
