// Small text files whole: presets, materials, lists of impulses.
#pragma once

#include "Object/Result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace idiophone {

/// The file's bytes; the error names a file that is missing, a directory, unreadable or larger than
/// the limit.
Result<std::string> readTextFile(const std::filesystem::path& file,
                                 std::uintmax_t limitBytes = std::uintmax_t{1} << 28);

/// The text without a byte order mark of UTF-8, which some editors put before it.
std::string_view withoutByteOrderMark(std::string_view text);

/// Writes the text, as `replaceFile` does; the error names a file that cannot be written.
Result<void> writeTextFile(const std::filesystem::path& file, const std::string& text);

} // namespace idiophone
