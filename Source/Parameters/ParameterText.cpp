// Formats and parses parameter values for people.
#include "Parameters/ParameterTable.h"
#include "Parameters/Units.h"
#include "Parameters/Words.h"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <iomanip>
#include <locale>
#include <sstream>
#include <string>

namespace idiophone {
namespace {

using enum ParameterScale;

std::string_view trimmed(std::string_view text) {
    const auto isSpace = [](unsigned char c) { return std::isspace(c) != 0; };
    while (!text.empty() && isSpace(text.front()))
        text.remove_prefix(1);
    while (!text.empty() && isSpace(text.back()))
        text.remove_suffix(1);
    return text;
}

std::string formatNumber(double value, int decimals) {
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream << std::fixed << std::setprecision(decimals) << value;
    std::string text = stream.str();
    if (text.find_first_of("123456789") == std::string::npos && text.front() == '-')
        text.erase(0, 1); // -0.04 to one decimal is 0.0
    return text;
}

/// Returns the decimals that show at least `significantDigits` digits of the rounded value.
int decimalsFor(double value, int significantDigits) {
    if (value == 0)
        return 0;
    const double unit = std::pow(10.0, std::floor(std::log10(value)) - significantDigits + 1);
    const double rounded = std::round(value / unit) * unit;
    const int magnitude = static_cast<int>(std::floor(std::log10(rounded) + 1e-9));
    return std::max(0, significantDigits - 1 - magnitude);
}

bool bySignificantDigits(ParameterScale scale) {
    return scale == logarithmic || scale == cubic;
}

constexpr double plainMaximum = 100;

bool isPlain(const ParameterInfo& info, ValueDisplay display) {
    return info.isPhysical && display == ValueDisplay::plain;
}

/// Hosts show the unit behind every text, also behind a name: "Off Hz".
bool isNamed(std::string_view text, const char* name, const char* unit) {
    return name != nullptr &&
           (sameWord(text, name) || sameWord(text, std::string(name) + " " + unit));
}

} // namespace

std::string formatParameter(const ParameterInfo& info, double value, ValueDisplay display) {
    const double inside = info.clamped(value);
    if (isPlain(info, display))
        return std::to_string(std::lround(plainMaximum * info.toNormalised(inside)));
    if (info.scale == onOff)
        return inside != 0 ? "On" : "Off";
    if (info.scale == choice)
        return std::string(choiceNames(info.parameter)[static_cast<std::size_t>(inside)]);
    if (info.minimumName != nullptr && inside == info.minimum)
        return info.minimumName;
    if (info.maximumName != nullptr && inside == info.maximum)
        return info.maximumName;
    std::string text =
        formatNumber(inside, bySignificantDigits(info.scale) ? decimalsFor(inside, info.decimals)
                                                             : info.decimals);
    if (*info.unit != '\0')
        text += std::string(" ") + info.unit;
    return text;
}

std::optional<double>
parseParameter(const ParameterInfo& info, std::string_view text, ValueDisplay display) {
    const auto value = parseUnclamped(info, text, display);
    return value ? std::optional(info.clamped(*value)) : std::nullopt;
}

std::optional<double>
parseUnclamped(const ParameterInfo& info, std::string_view text, ValueDisplay display) {
    text = trimmed(text);
    if (info.scale == onOff && (sameWord(text, "on") || sameWord(text, "off")))
        return sameWord(text, "on") ? 1.0 : 0.0;
    if (isNamed(text, info.minimumName, info.unit))
        return info.minimum;
    if (isNamed(text, info.maximumName, info.unit))
        return info.maximum;
    const auto names = choiceNames(info.parameter);
    for (std::size_t i = 0; i < names.size(); ++i)
        if (sameWord(text, names[i]))
            return static_cast<double>(i);

    const auto typed = parseTypedNumber(text);
    if (!typed)
        return std::nullopt;
    const double number = typed->number;
    if (typed->unit.empty())
        return isPlain(info, display) ? info.fromNormalised(number / plainMaximum) : number;
    if (info.scale == onOff || info.scale == choice)
        return std::nullopt;
    return inUnit(number, typed->unit, info.unit);
}

} // namespace idiophone
