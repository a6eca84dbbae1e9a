// Reads the parameters in presets and scenes.
#pragma once

#include "Instrument/JsonPlace.h"
#include "Parameters/ParameterTable.h"

#include <optional>
#include <string>
#include <vector>

namespace idiophone {

/// Sets the parameters that an object names, each to a number in its unit or to text as a person
/// would type it; ParameterValues::set clamps it. Returns the ids that this version does not know.
/// An error throws JsonPlace::Fault.
inline std::vector<std::string> readParameters(const JsonPlace& place, ParameterValues& values) {
    std::vector<std::string> unknown;
    for (const auto& [id, value] : place.members()) {
        const auto* info = findParameter(id);
        if (info == nullptr) {
            unknown.push_back(id);
            continue;
        }
        const auto& json = value.json();
        std::optional<double> parsed;
        if (json.is_string())
            parsed = parseParameter(*info, json.get<std::string>());
        else if (json.is_number())
            parsed = json.get<double>();
        if (!parsed)
            value.fail("is a value that it cannot take");
        values.set(info->parameter, *parsed);
    }
    return unknown;
}

} // namespace idiophone
