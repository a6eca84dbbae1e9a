// What a file or a host says, as part of an error.
#pragma once

#include <string>
#include <string_view>

namespace idiophone {

/// The text fit for one line: at most 100 bytes, then "..."; with '?' for control characters and
/// for bytes that are no UTF-8.
std::string oneLine(std::string_view text);

/// The same in single quotes.
std::string inQuotes(std::string_view text);

} // namespace idiophone
