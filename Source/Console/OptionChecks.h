// Checks for numbers on the command line. CLI11's own range lets "nan" through.
#pragma once

#include <CLI/CLI.hpp>

namespace idiophone {

/// A finite number from `lowest` to `highest`.
CLI::Validator numberBetween(double lowest, double highest);

} // namespace idiophone
