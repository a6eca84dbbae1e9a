// Checks of what stands on the command line.
#pragma once

#include "Object/Result.h"

#include <CLI/CLI.hpp>

namespace idiophone {

/// A finite number from `lowest` to `highest`. CLI11's own range lets "nan" through.
CLI::Validator numberBetween(double lowest, double highest);

/// The `type_name` of options whose file the command writes.
inline constexpr auto writtenFile = "OUTPUT";

/// Fails where such a file is one that the command line names elsewhere too, to be read or written.
Result<void> checkWrittenFiles(const CLI::App& command);

} // namespace idiophone
