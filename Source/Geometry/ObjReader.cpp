#include "Geometry/GroupNames.h"
#include "Geometry/MeshFile.h"

#include <algorithm>

namespace idiophone {
namespace {

/// Returns the 0-based vertex of a corner such as "7", "7/1/2" or "-1" (the latest vertex).
std::optional<std::int64_t> objCorner(std::string_view word, std::int64_t verticesSoFar) {
    const auto index = parseInteger(word.substr(0, word.find('/')));
    if (!index || *index == 0)
        return std::nullopt;
    return *index > 0 ? *index - 1 : verticesSoFar + *index;
}

/// Returns true if there are at least three corners and all have the same parts ("7", "7/1", "7//2"
/// or "7/1/2"), as the format requires. Some programs write "7/1/" and "7//" too.
bool isWholeFace(std::span<const std::string_view> corners) {
    const auto differs = [&](std::string_view corner) {
        return corner.ends_with('/') != corners.front().ends_with('/') ||
               std::ranges::count(corner, '/') != std::ranges::count(corners.front(), '/');
    };
    return corners.size() >= 3 && std::ranges::none_of(corners, differs);
}

/// Reads the statements of a file. A backslash at the end of a line continues a vertex or face.
class Statements {
public:
    explicit Statements(std::string_view bytes) : lines(TextScanner::ofFile(bytes)) {}

    /// Returns the next line; nothing at the end of the file.
    std::optional<std::string_view> next() {
        ++number;
        return lines.nextLine();
    }
    /// Returns a line joined with those that continue it, until the next call.
    std::string_view whole(std::string_view line) {
        if (!isContinued(line))
            return line;
        joined.clear();
        for (std::optional<std::string_view> part = line; part; part = next()) {
            const bool goesOn = isContinued(*part);
            const auto end = withoutBlankEnd(*part).size() - (goesOn ? 1 : 0);
            joined.append(part->substr(0, end)).append(" ");
            if (!goesOn)
                break;
        }
        return joined;
    }
    std::int64_t lineNumber() const { return number; } ///< from 1
    bool isAtEnd() const { return lines.bytesLeft() == 0; }

private:
    static bool isContinued(std::string_view line) { return withoutBlankEnd(line).ends_with('\\'); }

    TextScanner lines;
    std::string joined;
    std::int64_t number = 0;
};

} // namespace

Result<RawMesh> readObj(std::string_view bytes) {
    RawMesh mesh;
    Statements statements(bytes);
    const bool endsWithLineEnd = bytes.ends_with('\n') || bytes.ends_with('\r');
    std::vector<std::string_view> cornerWords;
    std::vector<std::int64_t> corners;
    GroupNames groupNames(mesh.groups);
    std::vector<std::size_t> ofObject, ofGroup; // groups of the next faces
    while (const auto line = statements.next()) {
        TextScanner rest(*line);
        const auto keyword = rest.nextWord();
        if (keyword == "g")
            ofGroup = groupNames.numbersOf(rest);
        else if (keyword == "o")
            ofObject = groupNames.numberOf(rest.nextLine().value_or(""));
        const bool isFace = keyword == "f" || keyword == "fo"; // "fo" is the former name
        if (keyword != "v" && !isFace)
            continue;
        const auto place = numbered("line", statements.lineNumber());
        TextScanner words(statements.whole(*line));
        words.nextWord();
        if (!isFace) {
            if (!mesh.addVertex(words))
                return failure(place + " is not a vertex of three numbers");
            continue;
        }
        cornerWords.clear();
        for (auto word = words.nextWord(); !word.empty(); word = words.nextWord())
            cornerWords.push_back(word);
        // A file may end without a newline, and malformed faces inside it are skipped. Only an
        // incomplete last line means that the file is truncated.
        if (statements.isAtEnd() && !endsWithLineEnd && !isWholeFace(cornerWords))
            return failure("it is truncated: " + place + ", its last, is half a face");
        corners.clear();
        for (const auto word : cornerWords) {
            const auto corner = objCorner(word, mesh.vertexCount());
            if (!corner)
                return failure(place + " is not a face");
            corners.push_back(*corner);
        }
        const auto polygon = mesh.polygonEnds.size();
        mesh.addPolygon(corners);
        if (mesh.polygonEnds.size() == polygon)
            continue;
        groupNames.addTo(ofObject, polygon);
        groupNames.addTo(ofGroup, polygon);
    }
    return mesh;
}

} // namespace idiophone
