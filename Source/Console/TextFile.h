// Small text files whole: presets, materials, lists of impulses.
#pragma once

#include "Object/Result.h"

#include <filesystem>
#include <string>

namespace idiophone {

/// The file's bytes; the error names a file that is missing, a directory, unreadable or larger than
/// 256 MB.
Result<std::string> readTextFile(const std::filesystem::path& file);

/// Writes the text; the error names a file that cannot be written.
Result<void> writeTextFile(const std::filesystem::path& file, const std::string& text);

} // namespace idiophone
