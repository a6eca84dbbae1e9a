// SPDX-License-Identifier: Apache-2.0
// Reads and writes whole text files: presets, materials, lists of impulses.
#pragma once

#include "Object/Result.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace idiophone {

/// Returns the file's bytes. The error names a file that is missing, a directory, unreadable or
/// larger than the limit.
Result<std::string> readTextFile(const std::filesystem::path& file,
                                 std::uintmax_t limitBytes = std::uintmax_t{1} << 28);

/// Writes the text as `replaceFile` does. The error names a file that cannot be written.
Result<void> writeTextFile(const std::filesystem::path& file, const std::string& text);

} // namespace idiophone
