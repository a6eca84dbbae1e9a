// Asks early whether a file can be written, so that a long task does not fail at its end.
#pragma once

#include "Object/Result.h"

#include <filesystem>

namespace idiophone {

/// Fails where `file` is a directory, or cannot be created beside where it will stand.
Result<void> checkWritable(const std::filesystem::path& file);

} // namespace idiophone
