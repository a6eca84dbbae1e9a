// Handles "--set PARAM=VALUE" through the parameter table.
#pragma once

#include "Object/Result.h"
#include "Parameters/ParameterTable.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace idiophone {

/// Adds the option, which may be given several times.
void addParameterAssignments(CLI::App& command, std::vector<std::string>& assignments);

/// Sets every PARAM=VALUE and returns the parameters. The error names an unknown parameter or the
/// valid values. AssignedEffect.h determines their effect.
Result<std::vector<ParameterId>> assignParameters(const std::vector<std::string>& assignments,
                                                  ParameterValues& values);

} // namespace idiophone
