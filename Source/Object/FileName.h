// Makes names of files that every system accepts.
#pragma once

#include <string>
#include <string_view>

namespace idiophone {

/// Replaces the letters that no file name may have on some system by '_'.
inline std::string fileNameFrom(std::string name) {
    constexpr std::string_view forbidden = "/\\:*?\"<>|";
    for (char& letter : name)
        if (static_cast<unsigned char>(letter) < 0x20 ||
            forbidden.find(letter) != std::string_view::npos)
            letter = '_';
    return name;
}

} // namespace idiophone
