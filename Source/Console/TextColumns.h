// Formats columns and paragraphs of UTF-8 text, for listings of at most 80 characters a line.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace idiophone {

inline constexpr std::size_t lineWidth = 80;

/// Pad a text with blanks to `width` characters, at its end or its beginning.
std::string leftColumn(std::string_view text, std::size_t width);
std::string rightColumn(std::string_view text, std::size_t width);

/// Breaks a text between words from the column `indent` on. Leaves out the first line's indent and
/// adds a line end.
std::string paragraph(std::string_view text, std::size_t indent);

} // namespace idiophone
