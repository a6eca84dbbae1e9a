// A parameter's value as presets and scenes have it in JSON.
#pragma once

#include "Parameters/ParameterTable.h"

#include <nlohmann/json.hpp>
#include <optional>
#include <string>

namespace idiophone {

/// Of a number in the parameter's unit, or of what a person would type; nothing where it is
/// neither. Values are held to their range where they are set.
inline std::optional<double> parameterOfJson(const ParameterInfo& info,
                                             const nlohmann::json& value) {
    if (value.is_string())
        return parseParameter(info, value.get<std::string>());
    return value.is_number() ? std::optional(value.get<double>()) : std::nullopt;
}

} // namespace idiophone
