// What a file or a host says, as part of an error.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace idiophone {

/// The text fit for one line: at most so many bytes, then "..."; with '?' for bytes that are no
/// UTF-8 and for those of control characters, among them what turns the direction of writing.
std::string oneLine(std::string_view text, std::size_t mostBytes = 100);

/// The same in single quotes.
std::string inQuotes(std::string_view text);

/// The text with control characters other than ends of lines and tabs as JSON writes them
/// ("\u001b"), so that a terminal shows them instead of doing what they say. Bytes that are no
/// UTF-8 stay, but for those that are control characters by themselves.
std::string escaped(std::string_view text);

/// Of the text's last bytes, how many begin a character that the text does not end.
std::size_t unfinishedBytes(std::string_view text);

} // namespace idiophone
