// Checks early whether a result can be written, so that a long task does not fail at its end.
#pragma once

#include "Object/Result.h"

#include <filesystem>

namespace idiophone {

/// Fails if `file` is a directory or no file can be created beside it.
Result<void> checkWritable(const std::filesystem::path& file);

/// Creates the directory if it does not exist. The error names the directory.
Result<void> makeDirectory(const std::filesystem::path& directory);

} // namespace idiophone
