#include "Geometry/GroupNames.h"
#include "Geometry/MeshFile.h"
#include "Object/SameName.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>

namespace idiophone {
namespace {

constexpr std::size_t headerBytes = 84, triangleBytes = 50;

float littleEndianFloat(const char* bytes) {
    std::array<char, 4> raw{bytes[0], bytes[1], bytes[2], bytes[3]};
    if constexpr (std::endian::native == std::endian::big)
        std::ranges::reverse(raw);
    return std::bit_cast<float>(raw);
}

std::uint32_t littleEndianCount(const char* bytes) {
    return std::bit_cast<std::uint32_t>(littleEndianFloat(bytes));
}

RawMesh readBinaryStl(std::string_view bytes, std::size_t count) {
    RawMesh mesh;
    mesh.coordinates.reserve(count * 9);
    mesh.corners.reserve(count * 3);
    mesh.polygonEnds.reserve(count);
    for (std::size_t face = 0; face < count; ++face) {
        const char* corners = bytes.data() + headerBytes + face * triangleBytes + 12;
        for (int i = 0; i < 9; ++i)
            mesh.coordinates.push_back(littleEndianFloat(corners + 4 * i));
        const auto first = static_cast<std::int64_t>(face) * 3;
        mesh.addPolygon(std::array{first, first + 1, first + 2});
    }
    return mesh;
}

/// Reads a file that goes on behind the triangles that its header counts. If the rest can be
/// triangles too, the count is taken to be wrong: some programs never write it.
RawMesh readMiscountedStl(std::string_view bytes, std::size_t count) {
    constexpr double largestCoordinate = 1e9;
    const auto held = (bytes.size() - headerBytes) / triangleBytes;
    const auto extra = bytes.size() - headerBytes - count * triangleBytes;
    if (extra % triangleBytes == 0) {
        auto mesh = readBinaryStl(bytes, held);
        if (std::ranges::all_of(mesh.coordinates,
                                [](double x) { return std::abs(x) <= largestCoordinate; })) {
            mesh.notes = "The file's header counts " + std::to_string(count) +
                         " triangles, but the file holds " + std::to_string(held) +
                         ": all are read.";
            return mesh;
        }
    }
    auto mesh = readBinaryStl(bytes, count);
    mesh.notes = "Left out " + std::to_string(extra) + " bytes behind the " +
                 std::to_string(count) + " triangles that the file's header counts.";
    return mesh;
}

/// Reads the keywords in any case, with or without blanks inside ("end loop").
class StlKeywords {
public:
    explicit StlKeywords(std::string_view text) : scanner(TextScanner::ofFile(text)) {}

    /// Returns the next word in lower case, until the next call; empty at the end of the file.
    std::string_view next() {
        word.clear();
        append();
        if (word == "end")
            append();
        return word;
    }
    TextScanner& text() { return scanner; }

    /// Returns the name of a solid, which has any number of words. It ends with its line, or
    /// before "facet normal"; then it counts as empty.
    std::string_view name() {
        auto ahead = scanner;
        auto text = scanner.nextLine().value_or("");
        for (auto part = ahead.nextWord(); ahead.bytesLeft() > scanner.bytesLeft();) {
            const bool isFacet = sameName(part, "facet");
            part = ahead.nextWord();
            if (isFacet && sameName(part, "normal")) {
                scanner = ahead;
                text = {};
            }
        }
        return text;
    }

private:
    void append() {
        for (const unsigned char letter : scanner.nextWord())
            word += static_cast<char>(std::tolower(letter));
    }

    TextScanner scanner;
    std::string word;
};

Result<RawMesh> readTextStl(std::string_view text) {
    RawMesh mesh;
    StlKeywords words(text);
    std::vector<std::int64_t> corners;
    bool isInFacet = false, ended = false;
    GroupNames groupNames(mesh.groups);
    std::vector<std::size_t> ofSolid; // groups of the next faces
    const auto endLoop = [&] {
        mesh.addPolygon(corners);
        if (corners.size() >= 3)
            groupNames.addTo(ofSolid, mesh.polygonEnds.size() - 1);
        corners.clear();
    };
    for (auto word = words.next(); !word.empty(); word = words.next()) {
        if (word == "vertex") {
            corners.push_back(mesh.vertexCount());
            if (!mesh.addVertex(words.text()))
                return failure(numbered("vertex", corners.back()) + " is not three numbers");
        } else if (word.starts_with("endloop")) {
            endLoop();
        } else if (word.starts_with("endfacet")) {
            endLoop(); // in case of no "endloop"
            isInFacet = false;
        } else if (word.starts_with("facet")) {
            isInFacet = true;
        } else if (word.starts_with("endsolid") || word.starts_with("solid")) {
            ended = word.starts_with("endsolid");
            const auto name = words.name();
            ofSolid = ended ? std::vector<std::size_t>{} : groupNames.numberOf(name);
        }
    }
    if (isInFacet || !corners.empty())
        return failure("it is truncated: it ends inside " +
                       numbered("triangle", static_cast<std::int64_t>(mesh.polygonEnds.size())));
    if (!ended)
        mesh.notes = "The file ends without \"endsolid\": the end of the mesh may be missing.";
    return mesh;
}

bool beginsWith(std::string_view text, std::string_view word) {
    return text.size() >= word.size() && sameName(text.substr(0, word.size()), word);
}

/// Returns whether the beginning has no control characters, as the counts and numbers of binary
/// files do.
bool isText(std::string_view bytes) {
    return std::ranges::none_of(bytes.substr(0, 1024), [](unsigned char byte) {
        return byte < 0x20 && std::isspace(byte) == 0;
    });
}

} // namespace

Result<RawMesh> readStl(std::string_view bytes) {
    const bool isLong = bytes.size() >= headerBytes;
    const std::uint64_t count = isLong ? littleEndianCount(bytes.data() + headerBytes - 4) : 0;
    const std::uint64_t expected = headerBytes + count * triangleBytes;
    // Binary files may begin with "solid" too: only the size is reliable.
    if (isLong && bytes.size() == expected)
        return readBinaryStl(bytes, count);
    const auto first = TextScanner(bytes).nextWord();
    if (isText(bytes) && (beginsWith(first, "solid") || beginsWith(first, "facet")))
        return readTextStl(bytes);
    if (!isLong)
        return failure("it is too short for an STL file");
    if (isText(bytes))
        return failure("it is a text that does not begin with \"solid\"");
    if (bytes.size() < expected)
        return failure("it is truncated or not an STL file: its header promises " +
                       std::to_string(count) + " triangles, there are " +
                       std::to_string((bytes.size() - headerBytes) / triangleBytes));
    return readMiscountedStl(bytes, count);
}

} // namespace idiophone
