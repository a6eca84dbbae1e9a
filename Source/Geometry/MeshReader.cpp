#include "Geometry/MeshReader.h"

#include "Geometry/MeshFile.h"
#include "Object/FileBytes.h"
#include "Object/SameName.h"
#include "Object/TextFile.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>
#include <string>

namespace idiophone {
namespace {

constexpr std::uintmax_t largestFileBytes = std::uintmax_t{2} << 30;

std::string numbered(const char* thing, std::int64_t number) {
    return thing + std::string(" ") + std::to_string(number);
}

/// Returns the 0-based vertex of a corner such as "7", "7/1/2" or "-1" (the latest vertex).
std::optional<std::int64_t> objCorner(std::string_view word, std::int64_t verticesSoFar) {
    const auto index = parseInteger(word.substr(0, word.find('/')));
    if (!index || *index == 0)
        return std::nullopt;
    return *index > 0 ? *index - 1 : verticesSoFar + *index;
}

/// Returns true if there are at least three corners and all have the same parts ("7", "7/1", "7//2"
/// or "7/1/2"), as the format requires.
bool isWholeFace(std::span<const std::string_view> corners) {
    const auto lacks = [&](std::string_view corner) {
        return corner.ends_with('/') ||
               std::ranges::count(corner, '/') != std::ranges::count(corners.front(), '/');
    };
    return corners.size() >= 3 && std::ranges::none_of(corners, lacks);
}

float littleEndianFloat(const char* bytes) {
    std::array<char, 4> raw{bytes[0], bytes[1], bytes[2], bytes[3]};
    if constexpr (std::endian::native == std::endian::big)
        std::ranges::reverse(raw);
    return std::bit_cast<float>(raw);
}

std::uint32_t littleEndianCount(const char* bytes) {
    return std::bit_cast<std::uint32_t>(littleEndianFloat(bytes));
}

Result<RawMesh> readBinaryStl(std::string_view bytes, std::uint32_t count) {
    RawMesh mesh;
    mesh.coordinates.reserve(std::size_t{count} * 9);
    mesh.triangles.reserve(std::size_t{count} * 3);
    for (std::uint32_t face = 0; face < count; ++face) {
        const char* corners = bytes.data() + 84 + std::size_t{face} * 50 + 12;
        for (int i = 0; i < 9; ++i)
            mesh.coordinates.push_back(littleEndianFloat(corners + 4 * i));
        const std::int64_t first = std::int64_t{face} * 3;
        mesh.triangles.insert(mesh.triangles.end(), {first, first + 1, first + 2});
    }
    return mesh;
}

Result<RawMesh> readTextStl(std::string_view bytes) {
    RawMesh mesh;
    TextScanner words(bytes);
    std::vector<std::int64_t> corners;
    bool ended = false;
    words.nextLine(); // "solid" and a name of any number of words
    for (auto word = words.nextWord(); !word.empty(); word = words.nextWord()) {
        if (word == "vertex") {
            corners.push_back(mesh.vertexCount());
            if (!mesh.addVertex(words))
                return failure(numbered("vertex", corners.back()) + " is not three numbers");
        } else if (word == "endloop") {
            mesh.addPolygon(corners);
            corners.clear();
        } else if (word == "endsolid") {
            ended = true;
            words.nextLine();
        } else if (word == "solid") {
            ended = false;
            words.nextLine();
        }
    }
    if (!ended)
        return failure("it ends before \"endsolid\"");
    return mesh;
}

Result<RawMesh> readRawMesh(const std::filesystem::path& file) {
    const auto extension = nameOf(file.extension());
    constexpr std::array<std::pair<std::string_view, Result<RawMesh> (*)(std::string_view)>, 4>
        formats{{{".obj", readObj}, {".off", readOff}, {".ply", readPly}, {".stl", readStl}}};
    for (const auto& [name, read] : formats)
        if (sameName(extension, name)) {
            const auto bytes = readBytes(file, largestFileBytes);
            if (!bytes)
                return failure(bytes.error().message);
            if (bytes->empty())
                return failure("it is empty");
            return read(*bytes);
        }
    return failure("its extension is none of .obj, .off, .ply and .stl");
}

/// Returns the first fault of the whole mesh; empty if there is none.
std::string faultOf(const RawMesh& raw, double metresPerUnit) {
    if (raw.triangles.empty())
        return "it has no faces";
    // Face corners and coordinates are counted in int.
    if (raw.coordinates.size() > std::numeric_limits<int>::max())
        return "it has too many vertices";
    if (raw.triangles.size() > std::numeric_limits<int>::max())
        return "it has too many faces";
    for (std::size_t i = 0; i < raw.coordinates.size(); ++i)
        if (!std::isfinite(raw.coordinates[i]) ||
            std::abs(raw.coordinates[i]) * metresPerUnit > 1e6)
            return numbered("vertex", static_cast<std::int64_t>(i / 3)) +
                   (std::isfinite(raw.coordinates[i]) ? " lies beyond 1000 km"
                                                      : " is not a finite number");
    for (std::size_t i = 0; i < raw.triangles.size(); ++i)
        if (raw.triangles[i] < 0 || raw.triangles[i] >= raw.vertexCount())
            return "a face names a vertex that does not exist (there are " +
                   std::to_string(raw.vertexCount()) + " vertices)";
    return {};
}

} // namespace

Result<RawMesh> readObj(std::string_view bytes) {
    RawMesh mesh;
    TextScanner lines(withoutByteOrderMark(bytes));
    std::vector<std::string_view> cornerWords;
    std::vector<std::int64_t> corners;
    std::int64_t number = 0;
    while (const auto line = lines.nextLine()) {
        ++number;
        TextScanner words(*line);
        const auto keyword = words.nextWord();
        if (keyword == "v") {
            if (!mesh.addVertex(words))
                return failure(numbered("line", number) + " is not a vertex of three numbers");
        } else if (keyword == "f") {
            cornerWords.clear();
            for (auto word = words.nextWord(); !word.empty(); word = words.nextWord())
                cornerWords.push_back(word);
            // A file may end without a newline, and malformed faces inside it are skipped. Only an
            // incomplete last line means that the file is truncated.
            if (lines.bytesLeft() == 0 && !bytes.ends_with('\n') && !isWholeFace(cornerWords))
                return failure("it is truncated: " + numbered("line", number) +
                               ", its last, is half a face");
            corners.clear();
            for (const auto word : cornerWords) {
                const auto corner = objCorner(word, mesh.vertexCount());
                if (!corner)
                    return failure(numbered("line", number) + " is not a face");
                corners.push_back(*corner);
            }
            mesh.addPolygon(corners);
        }
    }
    return mesh;
}

Result<RawMesh> readOff(std::string_view bytes) {
    TextScanner words(bytes);
    const auto magic = words.nextWord();
    if (!magic.ends_with("OFF"))
        return failure("it does not begin with \"OFF\"");
    const auto vertices = words.nextInteger(), faces = words.nextInteger(),
               edges = words.nextInteger();
    if (!vertices || !faces || !edges || *vertices < 0 || *faces < 0)
        return failure("its header is not three counts");
    // Three numbers and their separators take at least six bytes.
    const auto maximum = static_cast<std::int64_t>(words.bytesLeft() / 6 + 1);
    if (*vertices > maximum || *faces > maximum)
        return failure("its header promises " + std::to_string(*vertices) + " vertices and " +
                       std::to_string(*faces) + " faces, more than the file can hold");
    RawMesh mesh;
    words.nextLine();
    for (std::int64_t row = 0; row < *vertices + *faces; ++row) {
        std::string_view content;
        while (content.find_first_not_of(" \t\r\v\f") == std::string_view::npos) {
            const auto line = words.nextLine();
            if (!line)
                return failure("it ends after " + std::to_string(row) + " of " +
                               std::to_string(*vertices + *faces) + " vertices and faces");
            content = *line;
        }
        // Ignore the rest of the line (normals, colours).
        TextScanner numbers(content);
        if (row < *vertices) {
            if (!mesh.addVertex(numbers))
                return failure(numbered("vertex", row) + " is not three numbers");
            continue;
        }
        std::vector<std::int64_t> corners;
        const auto valence = numbers.nextInteger().value_or(-1);
        for (std::int64_t i = 0; i < valence; ++i) {
            const auto corner = numbers.nextInteger();
            if (!corner)
                break;
            corners.push_back(*corner);
        }
        if (static_cast<std::int64_t>(corners.size()) != valence)
            return failure(numbered("face", row - *vertices) + " is malformed");
        mesh.addPolygon(corners);
    }
    return mesh;
}

Result<RawMesh> readStl(std::string_view bytes) {
    const std::uint64_t count = bytes.size() >= 84 ? littleEndianCount(bytes.data() + 80) : 0;
    const std::uint64_t expected = 84 + count * 50;
    // Binary files may begin with "solid" too: only the size is reliable.
    if (bytes.size() >= 84 && bytes.size() == expected)
        return readBinaryStl(bytes, static_cast<std::uint32_t>(count));
    if (bytes.starts_with("solid"))
        return readTextStl(bytes);
    if (bytes.size() < 84)
        return failure("it is too short for an STL file");
    if (bytes.size() < expected)
        return failure("it is truncated: its header promises " + std::to_string(count) +
                       " triangles, there are " + std::to_string((bytes.size() - 84) / 50));
    return readBinaryStl(bytes, static_cast<std::uint32_t>(count));
}

Result<Mesh> readMesh(const std::filesystem::path& file, double metresPerUnit) {
    const auto fail = [&](const std::string& fault) {
        return failure("The mesh file \"" + nameOf(file) + "\" cannot be used: " + fault + ".");
    };
    if (!(metresPerUnit > 0) || !std::isfinite(metresPerUnit))
        return fail("its unit must be a positive number of metres");
    try {
        const auto raw = readRawMesh(file);
        if (!raw)
            return fail(raw.error().message);
        if (const auto fault = faultOf(*raw, metresPerUnit); !fault.empty())
            return fail(fault);
        Mesh mesh;
        using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
        mesh.vertices = Eigen::Map<const RowMajor>(raw->coordinates.data(), raw->vertexCount(), 3) *
                        metresPerUnit;
        using RowMajorIndices = Eigen::Matrix<std::int64_t, Eigen::Dynamic, 3, Eigen::RowMajor>;
        mesh.faces =
            Eigen::Map<const RowMajorIndices>(raw->triangles.data(), raw->triangles.size() / 3, 3)
                .cast<int>();
        return mesh;
    } catch (const std::bad_alloc&) {
        return fail("it is too large for this machine's memory");
    }
}

} // namespace idiophone
