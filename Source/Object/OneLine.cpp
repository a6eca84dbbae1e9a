#include "Object/OneLine.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr std::size_t longestBytes = 100;

/// The bytes of the character at the beginning of the text; 0 where it cannot be shown.
std::size_t shownBytes(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto lead = at(0);
    if (lead < 0x80)
        return lead >= ' ' && lead != 127 ? 1 : 0;
    const std::size_t size = lead < 0xc2 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
    if (size == 0 || lead > 0xf4 || size > text.size())
        return 0;
    if (!std::ranges::all_of(text.substr(1, size - 1),
                             [](unsigned char c) { return c >= 0x80 && c < 0xc0; }))
        return 0;
    // The second byte tells control characters, forms longer than need be, halves of pairs of
    // UTF-16, and what lies beyond Unicode.
    const auto second = at(1);
    const bool isWrong = (lead == 0xc2 && second < 0xa0) || (lead == 0xe0 && second < 0xa0) ||
                         (lead == 0xed && second >= 0xa0) || (lead == 0xf0 && second < 0x90) ||
                         (lead == 0xf4 && second >= 0x90);
    return isWrong ? 0 : size;
}

} // namespace

std::string oneLine(std::string_view text) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const auto size = shownBytes(text.substr(i));
        if (i + std::max<std::size_t>(size, 1) > longestBytes)
            return result + "...";
        if (size == 0)
            result += '?';
        result += text.substr(i, size);
        i += std::max<std::size_t>(size, 1);
    }
    return result;
}

std::string inQuotes(std::string_view text) {
    return '\'' + oneLine(text) + '\'';
}

} // namespace idiophone
