// SPDX-License-Identifier: Apache-2.0
// Makes names of files that every system accepts.
#pragma once

#include <algorithm>
#include <cstddef>
#include <string>
#include <string_view>

namespace idiophone {

/// Replaces the letters that no file name may have on some system by '_', and the dots of a name of
/// dots only. Cuts names in UTF-8 to 200 bytes, so that an ending fits behind them.
inline std::string fileNameFrom(std::string name) {
    constexpr std::string_view forbidden = "/\\:*?\"<>|";
    constexpr std::size_t maximumBytes = 200;
    for (char& letter : name)
        if (static_cast<unsigned char>(letter) < 0x20 ||
            forbidden.find(letter) != std::string_view::npos)
            letter = '_';
    if (name.find_first_not_of('.') == std::string::npos)
        std::ranges::replace(name, '.', '_');
    auto size = std::min(name.size(), maximumBytes);
    while (size > 0 && size < name.size() &&
           (static_cast<unsigned char>(name[size]) & 0xc0) == 0x80)
        --size;
    name.resize(size);
    return name;
}

} // namespace idiophone
