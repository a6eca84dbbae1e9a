// SPDX-License-Identifier: Apache-2.0
// Makes texts from files and hosts safe to show in an error.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace idiophone {

/// Returns at most `maximumBytes` bytes of the text, then "..." if it was cut. Replaces the bytes
/// of control characters and of invalid UTF-8 by '?'. Characters that change the writing direction
/// count as control characters.
std::string oneLine(std::string_view text, std::size_t maximumBytes = 100);

/// Returns the name of a file as part of a sentence: printable characters only, and the beginning
/// of a long name.
std::string shownName(std::string_view name);

/// Returns `oneLine(text)` in single quotes.
std::string inQuotes(std::string_view text);

/// Writes control characters as JSON does ("\u001b"), except line ends and tabs, so that a terminal
/// shows them and does not obey them. Keeps bytes that are not UTF-8, unless they are control
/// characters by themselves.
std::string escaped(std::string_view text);

/// Returns the number of bytes at the end that begin an incomplete character.
std::size_t unfinishedBytes(std::string_view text);

} // namespace idiophone
