// A file to write to before what is there is replaced.
#pragma once

#include <filesystem>
#include <optional>

namespace idiophone {

/// Makes an empty file beside `file`, of a name that no file had: the caller's to fill, and to
/// rename or remove. Nothing where none can be made.
std::optional<std::filesystem::path> makeFileBeside(const std::filesystem::path& file);

} // namespace idiophone
