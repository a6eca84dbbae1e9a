// A file to write to before what is there is replaced.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>

namespace idiophone {

/// Makes an empty file beside `file`, of a name that no file had: the caller's to fill, and to
/// rename or remove. Nothing where none can be made, or `file` is protected from being written.
std::optional<std::filesystem::path> makeFileBeside(const std::filesystem::path& file);

/// The file that it leads to, where it is a link, even where there is none yet; else itself.
std::filesystem::path behindLinks(const std::filesystem::path& file);

/// Lets a complete file beside it take the place of `file`, which is no link, with the permissions
/// of what was there. False where that fails: both stay.
bool putInPlace(const std::filesystem::path& beside, const std::filesystem::path& file);

/// Makes `file` what `write` writes, through a file beside it that takes its place once it is
/// complete, as `putInPlace` has it. False where that fails: what was there stays.
/// A device or a pipe is written as it is, and a link goes on leading to the file.
bool replaceFile(const std::filesystem::path& file,
                 const std::function<void(std::ostream&)>& write);

} // namespace idiophone
