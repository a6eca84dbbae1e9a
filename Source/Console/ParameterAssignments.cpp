#include "Console/ParameterAssignments.h"

#include <string>
#include <string_view>

namespace idiophone {
namespace {

std::string valuesOf(const ParameterInfo& info) {
    const auto names = choiceNames(info.parameter);
    if (!names.empty()) {
        std::string list;
        for (const auto name : names)
            list += (list.empty() ? "one of " : ", ") + std::string(name);
        return list;
    }
    if (info.scale == ParameterScale::onOff)
        return "on or off";
    return formatParameter(info, info.minimum) + " to " + formatParameter(info, info.maximum);
}

Result<ParameterId> assign(const std::string& assignment, ParameterValues& values) {
    const auto equals = assignment.find('=');
    if (equals == std::string::npos)
        return failure("--set " + assignment + ": write PARAM=VALUE");
    const auto id = assignment.substr(0, equals);
    const auto text = std::string_view(assignment).substr(equals + 1);
    const auto* info = findParameter(id);
    if (info == nullptr)
        return failure("--set " + assignment + ": there is no parameter '" + id +
                       "' (`idiophone parameters` lists them)");
    // The table would clamp a number out of range, which hides mistakes on a command line.
    const auto value = parseUnclamped(*info, text);
    if (!value || !(*value >= info->minimum && *value <= info->maximum))
        return failure("--set " + assignment + ": " + info->name + " takes " + valuesOf(*info));
    values.set(info->parameter, *value);
    return info->parameter;
}

} // namespace

void addParameterAssignments(CLI::App& command, std::vector<std::string>& assignments) {
    command
        .add_option("--set", assignments,
                    "Sets a parameter, for example decay=0.5; can be repeated")
        ->type_name("PARAM=VALUE")
        ->allow_extra_args(false);
}

Result<std::vector<ParameterId>> assignParameters(const std::vector<std::string>& assignments,
                                                  ParameterValues& values) {
    std::vector<ParameterId> assigned;
    for (const auto& assignment : assignments) {
        const auto parameter = assign(assignment, values);
        if (!parameter)
            return tl::unexpected(parameter.error());
        assigned.push_back(*parameter);
    }
    return assigned;
}

} // namespace idiophone
