// SPDX-License-Identifier: Apache-2.0
#include "Object/OneLine.h"

#include <algorithm>

namespace idiophone {
namespace {

/// Returns the length of a character with this first byte, or 0 if the byte is not a first byte.
std::size_t bytesFromLead(unsigned char lead) {
    if (lead < 0x80)
        return 1;
    return lead < 0xc2 || lead > 0xf4 ? 0 : lead < 0xe0 ? 2 : lead < 0xf0 ? 3 : 4;
}

/// A Unicode control character beyond ASCII, or a character that ends a line or changes the writing
/// direction, which can disguise a name.
struct WideControl {
    unsigned code = 0;
    std::size_t bytes = 0; ///< 0 if the text does not begin with one
};

WideControl wideControl(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    if (text.size() >= 2 && at(0) == 0xc2 && at(1) >= 0x80 && at(1) < 0xa0)
        return {at(1), 2};
    if (text.size() < 3 || at(0) != 0xe2 || (at(1) != 0x80 && at(1) != 0x81))
        return {};
    const unsigned code = 0x2000u + ((at(1) & 1u) << 6) + (at(2) & 0x3fu);
    const bool isControl = (code >= 0x2028 && code <= 0x202e) || (code >= 0x2066 && code <= 0x2069);
    return at(2) >= 0x80 && at(2) < 0xc0 && isControl ? WideControl{code, 3} : WideControl{};
}

/// Returns the length of the character at the beginning of the text, or 0 if it is not printable.
std::size_t shownBytes(std::string_view text) {
    const auto at = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
    const auto lead = at(0);
    if (lead < 0x80)
        return lead >= ' ' && lead != 127 ? 1 : 0;
    const auto size = bytesFromLead(lead);
    if (size == 0 || size > text.size())
        return 0;
    if (!std::ranges::all_of(text.substr(1, size - 1),
                             [](unsigned char c) { return c >= 0x80 && c < 0xc0; }))
        return 0;
    // The second byte reveals overlong forms, UTF-16 surrogates and values beyond Unicode.
    const auto second = at(1);
    const bool isWrong = wideControl(text).bytes > 0 || (lead == 0xe0 && second < 0xa0) ||
                         (lead == 0xed && second >= 0xa0) || (lead == 0xf0 && second < 0x90) ||
                         (lead == 0xf4 && second >= 0x90);
    return isWrong ? 0 : size;
}

} // namespace

std::string oneLine(std::string_view text, std::size_t maximumBytes) {
    std::string result;
    for (std::size_t i = 0; i < text.size();) {
        const auto size = shownBytes(text.substr(i));
        if (i + std::max<std::size_t>(size, 1) > maximumBytes)
            return result + "...";
        if (size == 0)
            result += '?';
        result += text.substr(i, size);
        i += std::max<std::size_t>(size, 1);
    }
    return result;
}

std::string shownName(std::string_view name) {
    constexpr std::size_t maximumBytes = 500; // keeps paths long enough to recognise
    return oneLine(name, maximumBytes);
}

std::string inQuotes(std::string_view text) {
    return '\'' + oneLine(text) + '\'';
}

std::string escaped(std::string_view text) {
    constexpr std::string_view digits = "0123456789abcdef";
    std::string result;
    const auto escape = [&](unsigned code) {
        result += "\\u";
        for (int shift = 12; shift >= 0; shift -= 4)
            result += digits[(code >> shift) & 15];
    };
    while (!text.empty()) {
        const auto lead = static_cast<unsigned char>(text[0]);
        std::size_t size = std::max<std::size_t>(shownBytes(text), 1);
        if (const auto control = wideControl(text); control.bytes > 0) {
            size = control.bytes;
            escape(control.code);
        } else if ((lead < ' ' && lead != '\n' && lead != '\t') || lead == 127 ||
                   (lead >= 0x80 && lead < 0xa0)) {
            escape(lead);
        } else {
            result += text.substr(0, size);
        }
        text.remove_prefix(size);
    }
    return result;
}

std::size_t unfinishedBytes(std::string_view text) {
    for (std::size_t count = 1; count <= std::min<std::size_t>(text.size(), 3); ++count) {
        const auto byte = static_cast<unsigned char>(text[text.size() - count]);
        if (byte < 0x80 || byte >= 0xc0)
            return bytesFromLead(byte) > count ? count : 0;
    }
    return 0;
}

} // namespace idiophone
