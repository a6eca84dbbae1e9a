// Asks early whether what is made can be written, so that a long task does not fail at its end.
#pragma once

#include "Object/Result.h"

#include <filesystem>

namespace idiophone {

/// Fails where `file` is a directory, or cannot be created beside where it will stand.
Result<void> checkWritable(const std::filesystem::path& file);

/// Makes the directory where there is none. The error names it.
Result<void> makeDirectory(const std::filesystem::path& directory);

} // namespace idiophone
