// Columns and paragraphs of UTF-8 text, for listings of at most 80 characters a line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace idiophone {

inline constexpr std::size_t lineWidth = 80;

/// Filled with blanks to so many characters, at its end or its beginning.
std::string leftColumn(std::string_view text, std::size_t width);
std::string rightColumn(std::string_view text, std::size_t width);

/// The text broken between words, from the column `indent` on; without the indent of its first line
/// and with the end of its last.
std::string paragraph(std::string_view text, std::size_t indent);

} // namespace idiophone
