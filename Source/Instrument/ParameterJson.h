// Reads a parameter's value from the JSON of presets and scenes.
#pragma once

#include "Parameters/ParameterTable.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace idiophone {

/// Reads a number in the parameter's unit, or text as a person would type it. Returns nothing for
/// anything else. ParameterValues::set clamps the value to its range.
inline std::optional<double> parameterOfJson(const ParameterInfo& info,
                                             const nlohmann::json& value) {
    if (value.is_string())
        return parseParameter(info, value.get<std::string>());
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

} // namespace idiophone
