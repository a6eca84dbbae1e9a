// "--set PARAM=VALUE" through the parameter table.
#pragma once

#include "Object/Result.h"
#include "Parameters/ParameterTable.h"

#include <CLI/CLI.hpp>
#include <string>
#include <vector>

namespace idiophone {

/// Adds the option, which may be given many times.
void addParameterAssignments(CLI::App& command, std::vector<std::string>& assignments);

/// Sets every PARAM=VALUE and returns which they are. The error says which parameter does not
/// exist, or which values it takes. What they come to is AssignedEffect.h's.
Result<std::vector<ParameterId>> assignParameters(const std::vector<std::string>& assignments,
                                                  ParameterValues& values);

} // namespace idiophone
