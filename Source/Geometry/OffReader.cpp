#include "Geometry/MeshFile.h"
#include "Object/SameName.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace idiophone {
namespace {

/// The first word: [ST][C][N][4][n]OFF. Colours, normals and textures follow a vertex on its line.
struct OffKind {
    bool isHomogeneous = false;    ///< a fourth coordinate divides the others
    bool mayNameDimension = false; ///< "nOFF"; in lower case also "NOFF"
};

/// Returns the numbers of the next line that is not blank; none at the end of the file or if a word
/// is no count.
std::vector<std::int64_t> countsOfLine(TextScanner& lines) {
    std::vector<std::int64_t> counts;
    while (counts.empty()) {
        const auto line = lines.nextLine();
        if (!line)
            break;
        TextScanner words(*line);
        for (auto word = words.nextWord(); !word.empty(); word = words.nextWord()) {
            const auto count = parseInteger(word);
            if (!count || *count < 0)
                return {};
            counts.push_back(*count);
        }
    }
    return counts;
}

/// Returns the counts of vertices and faces, or nothing. Some programs leave out the number of
/// edges, or put each number on a line of its own.
std::optional<std::array<std::int64_t, 2>> readCounts(TextScanner& lines) {
    const auto first = countsOfLine(lines);
    if (first.size() >= 2)
        return std::array{first[0], first[1]};
    const auto second = first.empty() ? first : countsOfLine(lines);
    if (second.empty())
        return std::nullopt;
    auto ahead = lines;
    if (second.size() == 1 && countsOfLine(ahead).size() == 1)
        lines = ahead;
    return std::array{first[0], second[0]};
}

int upper(unsigned char letter) {
    return std::toupper(letter);
}

bool readVertex(TextScanner& words, const OffKind& kind, RawMesh& mesh) {
    if (!mesh.addVertex(words))
        return false;
    if (!kind.isHomogeneous)
        return true;
    const auto weight = words.nextNumber();
    for (auto i = mesh.coordinates.size() - 3; weight && i < mesh.coordinates.size(); ++i)
        mesh.coordinates[i] /= *weight;
    return weight.has_value();
}

bool readFace(TextScanner& words, RawMesh& mesh) {
    std::vector<std::int64_t> corners;
    const auto valence = words.nextInteger().value_or(-1);
    for (std::int64_t i = 0; i < valence; ++i) {
        const auto corner = words.nextInteger();
        if (!corner)
            return false;
        corners.push_back(*corner);
    }
    mesh.addPolygon(corners);
    return valence >= 0;
}

Result<RawMesh>
readRows(TextScanner& words, const OffKind& kind, std::array<std::int64_t, 2> counts) {
    const auto [vertices, faces] = counts;
    RawMesh mesh;
    for (std::int64_t row = 0; row < vertices + faces; ++row) {
        // A row may go on in the next line. What follows on its last line is colours and the like.
        auto rest = words;
        if (rest.nextWord().empty())
            return failure("it ends after " + std::to_string(row) + " of " +
                           std::to_string(vertices + faces) + " vertices and faces");
        if (row < vertices && !readVertex(words, kind, mesh))
            return failure(numbered("vertex", row) + " is not three numbers");
        if (row >= vertices && !readFace(words, mesh))
            return failure(numbered("face", row - vertices) + " is malformed");
        words.nextLine();
    }
    return mesh;
}

} // namespace

Result<RawMesh> readOff(std::string_view bytes) {
    auto lines = TextScanner::ofFile(bytes);
    OffKind kind;
    auto words = lines;
    if (const auto word = words.nextWord(); !parseInteger(word)) {
        const auto off = std::ranges::search(word, std::string_view("OFF"), {}, upper, upper);
        const std::string_view before(word.begin(), off.begin()), behind(off.end(), word.end());
        // ModelNet writes "OFF8 6 0".
        if (off.empty() || before.find_first_not_of("STCN4nstc") != before.npos ||
            !(behind.empty() || parseInteger(behind)))
            return failure("it does not begin with \"OFF\" or a count");
        kind.isHomogeneous = before.find('4') != before.npos;
        kind.mayNameDimension = before.find('n') != before.npos;
        lines = TextScanner::ofFile(bytes.substr(bytes.size() - words.bytesLeft() - behind.size()));
        if (sameName(words.nextWord(), "BINARY"))
            return failure("it is a binary OFF file; save it as text");
    }
    if (auto ahead = lines; kind.mayNameDimension) {
        if (const auto first = countsOfLine(ahead); first.size() == 1) {
            if (first.front() != 3 || kind.isHomogeneous)
                return failure("its vertices do not have three dimensions");
            lines = ahead;
        }
    }
    const auto counts = readCounts(lines);
    if (!counts)
        return failure("its header does not count vertices and faces");
    // The rows take at least six and two bytes, with their separators.
    const auto [vertices, faces] = *counts;
    const auto bytesLeft = static_cast<std::int64_t>(lines.bytesLeft());
    if (vertices > bytesLeft / 6 + 1 || faces > bytesLeft / 2 + 1)
        return failure("its header promises " + std::to_string(vertices) + " vertices and " +
                       std::to_string(faces) + " faces, more than the file can hold");
    return readRows(lines, kind, *counts);
}

} // namespace idiophone
