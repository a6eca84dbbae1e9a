// SPDX-License-Identifier: Apache-2.0
// Reads whole files, and converts file names to and from text.
#pragma once

#include "Object/OneLine.h"
#include "Object/Result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace idiophone {

/// Returns the file's bytes. The error is the end of a sentence that begins with the file's name,
/// for example "it is a directory". Fails if the file cannot be opened or read, or exceeds the
/// limit or the memory.
Result<std::string> readBytes(const std::filesystem::path& file, std::uintmax_t limitBytes);

/// Returns the path in UTF-8 on every system.
std::string nameOf(const std::filesystem::path& file);

/// Returns `shownName` of the path, which may come from an untrusted file.
std::string shownNameOf(const std::filesystem::path& file);

/// Returns the path in UTF-8 with forward slashes, to be stored in files: every system reads these.
std::string storedNameOf(const std::filesystem::path& file);

/// Returns the path of a name in UTF-8. Empty if this system cannot represent it.
std::filesystem::path pathNamed(std::string_view name);

/// Returns whether Windows treats the name as a network share or device: it begins with two
/// separators of either kind, or with "\??\".
bool isNetworkName(std::string_view name);

/// Returns isNetworkName(name) on Windows, else false. Windows would contact the named machine and
/// identify the user to it, so a path from a file must not name one.
bool leadsIntoNetwork(std::string_view name);

/// Returns a name from an untrusted file. If it leads into the network, removes its prefix; no
/// file has the shorter name.
std::string localName(std::string_view name);

} // namespace idiophone
