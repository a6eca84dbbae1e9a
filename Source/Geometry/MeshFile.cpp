#include "Geometry/MeshFile.h"

#include <algorithm>
#include <charconv>
#include <version>
#ifndef __cpp_lib_to_chars
#include <locale>
#include <sstream>
#endif

namespace idiophone {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

std::string_view withoutPlus(std::string_view word) {
    return word.starts_with('+') ? word.substr(1) : word;
}

} // namespace

void RawMesh::addPolygon(const std::vector<std::int64_t>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.insert(triangles.end(), {corners[0], corners[i - 1], corners[i]});
}

std::string_view TextScanner::nextWord() {
    while (true) {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
        if (!rest_.starts_with('#'))
            break;
        rest_.remove_prefix(std::min(rest_.find('\n'), rest_.size()));
    }
    const auto word = rest_.substr(0, rest_.find_first_of(blanks));
    rest_.remove_prefix(word.size());
    return word;
}

std::optional<double> TextScanner::nextNumber() {
    return parseNumber(nextWord());
}

std::optional<std::int64_t> TextScanner::nextInteger() {
    return parseInteger(nextWord());
}

std::optional<std::string_view> TextScanner::nextLine() {
    if (rest_.empty())
        return std::nullopt;
    const auto end = rest_.find('\n');
    auto line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return line.substr(0, line.find('#'));
}

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
