// Checks options of the command line, and early whether results can be written, so that a long task
// does not fail at its end.
#pragma once

#include "Object/Result.h"

#include <CLI/CLI.hpp>
#include <filesystem>

namespace idiophone {

/// Accepts a finite number from `lowest` to `highest`. CLI11's own range accepts "nan".
CLI::Validator numberBetween(double lowest, double highest);

/// Accepts a unit of length, such as mm.
CLI::Validator unitOfLength();

/// The `type_name` of options whose file the command writes.
inline constexpr auto writtenFile = "OUTPUT";

/// Fails if an output file cannot be written, or if the command line names it again for reading or
/// writing.
Result<void> checkWrittenFiles(const CLI::App& command);

/// Fails if `file` is a directory or no file can be created beside it.
Result<void> checkWritable(const std::filesystem::path& file);

/// Creates the directory if it does not exist. The error names it.
Result<void> makeDirectory(const std::filesystem::path& directory);

} // namespace idiophone
