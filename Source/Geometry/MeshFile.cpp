#include "Geometry/MeshFile.h"

#include "Object/FileBytes.h"
#include "Object/SameName.h"

#include <algorithm>

namespace idiophone {
namespace {

constexpr std::string_view blanks = " \t\r\n\v\f";

} // namespace

bool hasExtension(const std::filesystem::path& file, std::string_view extension) {
    return sameName(nameOf(file.extension()), extension);
}

std::string_view withoutBlankEnd(std::string_view text) {
    return text.substr(0, text.find_last_not_of(blanks) + 1);
}

std::string numbered(const char* thing, std::int64_t number) {
    return thing + std::string(" ") + std::to_string(number);
}

void RawMesh::addPolygon(std::span<const std::int64_t> cornersOfPolygon) {
    if (cornersOfPolygon.size() < 3)
        return;
    corners.insert(corners.end(), cornersOfPolygon.begin(), cornersOfPolygon.end());
    polygonEnds.push_back(corners.size());
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

TextScanner TextScanner::ofFile(std::string_view text) {
    const auto end = text.find_first_of("\r\n");
    const bool isLone = end != std::string_view::npos && text[end] == '\r' &&
                        !text.substr(end + 1).starts_with('\n');
    return TextScanner(text, isLone ? '\r' : '\n');
}

std::string_view TextScanner::nextWord() {
    while (true) {
        rest_.remove_prefix(std::min(rest_.find_first_not_of(blanks), rest_.size()));
        if (!rest_.starts_with('#'))
            break;
        rest_.remove_prefix(std::min(rest_.find(lineEnd_), rest_.size()));
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
    const auto end = rest_.find(lineEnd_);
    auto line = rest_.substr(0, end);
    rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
    return line.substr(0, line.find('#'));
}

} // namespace idiophone
