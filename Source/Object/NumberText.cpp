// SPDX-License-Identifier: Apache-2.0
#include "Object/NumberText.h"

#include "Object/SameName.h"

#include <charconv>
#include <limits>
#include <locale>
#include <sstream>
#include <system_error>
#include <version>

namespace idiophone {
namespace {

std::string_view withoutPlus(std::string_view word) {
    return word.starts_with('+') ? word.substr(1) : word;
}

#ifndef __cpp_lib_to_chars
/// Replaces from_chars in libraries that lack it for floating point. Streams do not accept "nan"
/// and "inf", but accept hexadecimal numbers and white space.
std::optional<double> numberFromStream(std::string_view word) {
    const bool isNegative = word.starts_with('-');
    const auto name = word.substr(isNegative ? 1 : 0);
    using Limits = std::numeric_limits<double>;
    if (sameName(name, "nan"))
        return Limits::quiet_NaN();
    if (sameName(name, "inf") || sameName(name, "infinity"))
        return isNegative ? -Limits::infinity() : Limits::infinity();
    if (word.starts_with('+') || word.find_first_not_of("0123456789.eE+-") != word.npos)
        return std::nullopt;
    std::istringstream stream{std::string(word)};
    stream.imbue(std::locale::classic());
    double value = 0;
    if (!(stream >> value) || stream.peek() != std::istringstream::traits_type::eof())
        return std::nullopt;
    return value;
}
#endif

} // namespace

std::optional<double> parseNumber(std::string_view word) {
    word = withoutPlus(word);
#ifdef __cpp_lib_to_chars
    double value = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || fault != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
#else
    return numberFromStream(word);
#endif
}

std::optional<std::int64_t> parseInteger(std::string_view word) {
    word = withoutPlus(word);
    std::int64_t value = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || fault != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

std::string numberText(double value, int digits) {
    // macOS before 13.3 lacks to_chars for floating point.
    std::ostringstream stream;
    stream.imbue(std::locale::classic());
    stream.precision(digits);
    stream << value;
    return stream.str();
}

} // namespace idiophone
