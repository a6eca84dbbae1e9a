// A polygon collector and a text scanner for the readers of the mesh formats. Internal to Geometry.
// libigl's readers are not used, because on malformed files they exit the program or overrun
// buffers (docs/decisions).
#pragma once

#include "Object/NumberText.h"
#include "Object/Result.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

class TextScanner;

/// Polygons with a name, ascending.
struct RawGroup {
    std::string name;
    std::vector<std::size_t> polygons;
};

/// Vertices and polygons from a file. Indices are not checked yet.
struct RawMesh {
    std::vector<double> coordinates;      ///< [N,3]
    std::vector<std::int64_t> corners;    ///< of all polygons
    std::vector<std::size_t> polygonEnds; ///< [P] where the polygon ends in `corners`
    std::string notes;                    ///< sentences for the user; may be empty
    std::vector<RawGroup> groups;         ///< some may be empty
    bool isInMetres = false;              ///< the format says so

    std::int64_t vertexCount() const { return static_cast<std::int64_t>(coordinates.size() / 3); }
    /// Leaves out what has fewer than three corners.
    void addPolygon(std::span<const std::int64_t> cornersOfPolygon);
    /// Adds the vertex of the next three numbers. Returns false if they are not numbers.
    bool addVertex(TextScanner& numbers);
};

/// Reads a text word by word without copies. '#' starts a comment that ends with its line.
class TextScanner {
public:
    explicit TextScanner(std::string_view text, char lineEnd = '\n')
        : rest_(text), lineEnd_(lineEnd) {}
    /// Finds the line end of a whole file: a line feed, or a lone carriage return.
    static TextScanner ofFile(std::string_view text);

    /// Returns the next word on this or a later line; empty at the end of the text.
    std::string_view nextWord();
    std::optional<double> nextNumber();
    std::optional<std::int64_t> nextInteger();
    /// Returns the rest of the current line without line end and comment; nothing at the end of the
    /// text.
    std::optional<std::string_view> nextLine();
    std::size_t bytesLeft() const { return rest_.size(); }

private:
    std::string_view rest_;
    char lineEnd_;
};

/// Returns whether the name has the extension, such as ".obj", in upper or lower case.
bool hasExtension(const std::filesystem::path& file, std::string_view extension);

/// Returns the text without the white space at its end.
std::string_view withoutBlankEnd(std::string_view text);

/// Returns "vertex 7".
std::string numbered(const char* thing, std::int64_t number);

/// One reader per format. Errors name the fault only; readMesh adds the file. The bytes have no
/// byte order mark.
Result<RawMesh> readObj(std::string_view bytes);
Result<RawMesh> readOff(std::string_view bytes);
Result<RawMesh> readPly(std::string_view bytes);
Result<RawMesh> readStl(std::string_view bytes);
/// Reads buffers in files of their own from the folder.
Result<RawMesh> readGltf(std::string_view bytes, const std::filesystem::path& folder);

} // namespace idiophone
