#include "Console/TextColumns.h"

#include <algorithm>

namespace idiophone {
namespace {

std::size_t characters(std::string_view text) {
    return static_cast<std::size_t>(
        std::ranges::count_if(text, [](char c) { return (c & 0xc0) != 0x80; }));
}

std::string blanksTo(std::string_view text, std::size_t width) {
    return std::string(width - std::min(width, characters(text)), ' ');
}

} // namespace

std::string leftColumn(std::string_view text, std::size_t width) {
    return std::string(text) + blanksTo(text, width);
}

std::string rightColumn(std::string_view text, std::size_t width) {
    return blanksTo(text, width) + std::string(text);
}

std::string paragraph(std::string_view text, std::size_t indent) {
    std::string lines;
    std::size_t column = indent;
    while (!text.empty()) {
        const auto word = text.substr(0, text.find(' '));
        text.remove_prefix(std::min(word.size() + 1, text.size()));
        if (column > indent && column + 1 + characters(word) > lineWidth) {
            lines += '\n' + std::string(indent, ' ');
            column = indent;
        } else if (column > indent) {
            lines += ' ';
            ++column;
        }
        lines += word;
        column += characters(word);
    }
    return lines + '\n';
}

} // namespace idiophone
