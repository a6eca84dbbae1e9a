#include "Object/NumberText.h"

#include <charconv>
#include <version>
#ifndef __cpp_lib_to_chars
#include <locale>
#include <sstream>
#include <string>
#endif

namespace idiophone {
namespace {

std::string_view withoutPlus(std::string_view word) {
    return word.starts_with('+') ? word.substr(1) : word;
}

} // namespace

std::optional<double> parseNumber(std::string_view word) {
    word = withoutPlus(word);
    double value = 0;
#ifdef __cpp_lib_to_chars
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || fault != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
#else
    std::istringstream stream{std::string(word)};
    stream.imbue(std::locale::classic());
    if (!(stream >> value) || stream.peek() != std::istringstream::traits_type::eof())
        return std::nullopt;
#endif
    return value;
}

std::optional<std::int64_t> parseInteger(std::string_view word) {
    word = withoutPlus(word);
    std::int64_t value = 0;
    const auto [end, fault] = std::from_chars(word.data(), word.data() + word.size(), value);
    if (word.empty() || fault != std::errc{} || end != word.data() + word.size())
        return std::nullopt;
    return value;
}

} // namespace idiophone
