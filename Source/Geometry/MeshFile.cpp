#include "Geometry/MeshFile.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

} // namespace

void RawMesh::addPolygon(const std::vector<std::int64_t>& corners) {
    for (std::size_t i = 2; i < corners.size(); ++i)
        triangles.insert(triangles.end(), {corners[0], corners[i - 1], corners[i]});
}

bool RawMesh::addVertex(TextScanner& numbers) {
    for (int axis = 0; axis < 3; ++axis) {
        const auto number = numbers.nextNumber();
        if (!number)
            return false;
        coordinates.push_back(*number);
    }
    return true;
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

} // namespace idiophone
