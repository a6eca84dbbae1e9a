#include "Parameters/ParameterTable.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace idiophone {
namespace {

using enum ParameterScale;

// A fraction of the maximum. Smaller values become 0, because they would need too many digits.
constexpr double smallestCubicShare = 5e-7;

bool isWhole(ParameterScale scale) {
    return scale == steps || scale == onOff || scale == choice;
}

} // namespace

const char* scaleName(ParameterScale scale) noexcept {
    constexpr std::array names{"linear", "logarithmic", "steps", "on-off", "choice", "cubic"};
    return names[static_cast<std::size_t>(scale)];
}

double ParameterInfo::toNormalised(double value) const {
    const double inside = clamped(value);
    if (scale == logarithmic)
        return std::log(inside / minimum) / std::log(maximum / minimum);
    if (scale == cubic)
        return std::cbrt(inside / maximum);
    return (inside - minimum) / (maximum - minimum);
}

double ParameterInfo::fromNormalised(double normalised) const {
    const double inside =
        std::isnan(normalised) ? toNormalised(defaultValue) : std::clamp(normalised, 0.0, 1.0);
    if (scale == logarithmic)
        return clamped(minimum * std::pow(maximum / minimum, inside));
    if (scale == cubic)
        return clamped(inside * inside * inside * maximum);
    return clamped(minimum + inside * (maximum - minimum));
}

double ParameterInfo::clamped(double value) const {
    if (std::isnan(value))
        return defaultValue;
    const double inside = std::clamp(value, minimum, maximum);
    if (scale == cubic && inside < smallestCubicShare * maximum)
        return 0;
    return isWhole(scale) ? std::round(inside) : inside;
}

const ParameterInfo& parameterInfo(ParameterId parameter) {
    return parameterTable()[static_cast<std::size_t>(parameter)];
}

const ParameterInfo* findParameter(std::string_view id) {
    const auto table = parameterTable();
    const auto found =
        std::ranges::find_if(table, [&](const ParameterInfo& info) { return id == info.id; });
    return found == table.end() ? nullptr : &*found;
}

ParameterValues::ParameterValues() {
    for (const auto& info : parameterTable())
        values[static_cast<std::size_t>(info.parameter)] = info.defaultValue;
}

void ParameterValues::set(ParameterId parameter, double value) {
    values[static_cast<std::size_t>(parameter)] = parameterInfo(parameter).clamped(value);
}

ParameterValues withSetupOf(const ParameterValues& setup, ParameterValues values) {
    for (const auto& info : parameterTable())
        if (info.isSetup)
            values.set(info.parameter, setup[info.parameter]);
    return values;
}

} // namespace idiophone
