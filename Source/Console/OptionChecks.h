// Checks options of the command line.
#pragma once

#include "Object/Result.h"

#include <CLI/CLI.hpp>

namespace idiophone {

/// Accepts a finite number from `lowest` to `highest`. CLI11's own range accepts "nan".
CLI::Validator numberBetween(double lowest, double highest);

/// The `type_name` of options whose file the command writes.
inline constexpr auto writtenFile = "OUTPUT";

/// Fails if an output file cannot be written, or if the command line names it again for reading or
/// writing.
Result<void> checkWrittenFiles(const CLI::App& command);

} // namespace idiophone
