// SPDX-License-Identifier: Apache-2.0
// Writes a file completely before it replaces an existing one.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <ostream>

namespace idiophone {

/// Creates an empty file with a new name beside `file`, for the caller to fill and to rename or
/// remove. Returns nothing if that fails or `file` is write-protected.
std::optional<std::filesystem::path> makeFileBeside(const std::filesystem::path& file);

/// Returns the target of a link, even if it does not exist yet. Returns any other path unchanged.
std::filesystem::path behindLinks(const std::filesystem::path& file);

/// Replaces `file`, which must not be a link, by a complete file beside it. Keeps the permissions
/// of `file`. Returns false and keeps both files if that fails.
bool putInPlace(const std::filesystem::path& beside, const std::filesystem::path& file);

/// Writes `file` by `write`, through a file beside it and `putInPlace`. Returns false and keeps the
/// existing file if that fails. Writes devices and pipes directly. A link stays a link to the file.
bool replaceFile(const std::filesystem::path& file,
                 const std::function<void(std::ostream&)>& write);

} // namespace idiophone
