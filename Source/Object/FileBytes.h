// Files whole, and their names in sentences.
#pragma once

#include "Object/Result.h"

#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>

namespace idiophone {

/// The file's bytes. The error is what is wrong, to be put after the file's name: "it is a
/// directory", that it cannot be opened or read, or is larger than the limit or than the memory.
Result<std::string> readBytes(const std::filesystem::path& file, std::uintmax_t limitBytes);

/// The path in UTF-8, as all our texts are, on every system.
std::string nameOf(const std::filesystem::path& file);

/// The same as part of a sentence: what can be shown of it, and of a long one the beginning. It may
/// come from a file that says where another one lies.
std::string shownNameOf(const std::filesystem::path& file);
/// Of a name in UTF-8.
std::string shownName(std::string_view name);

/// The path in UTF-8 with forward slashes, as files of ours keep it: every system reads these.
std::string storedNameOf(const std::filesystem::path& file);

/// The path that a name in UTF-8 tells; empty where it can be none on this system.
std::filesystem::path pathNamed(std::string_view name);

/// Whether Windows takes the name for a share's or a device's: it begins with two separators, of
/// either kind, or with "\??\".
bool isNetworkName(std::string_view name);

/// The same where this is Windows, which asks the machine that the name tells and shows it who the
/// user is: not to be done because a file says so.
bool leadsIntoNetwork(std::string_view name);

/// A name that stands in a file from anybody: where it leads into the network, without what leads
/// there, so that there is nothing of that name.
std::string localName(std::string_view name);

} // namespace idiophone
