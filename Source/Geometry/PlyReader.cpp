#include "Geometry/MeshFile.h"
#include "Object/OneLine.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>
#include <span>
#include <string>

namespace idiophone {
namespace {

enum class Encoding { text, littleEndian, bigEndian };
template <class T>
double valueOf(const char* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return static_cast<double>(value);
}

/// A type of numbers, under both of its names.
struct Scalar {
    std::string_view name, newName;
    std::size_t bytes;
    double (*value)(const char* bytes); ///< in this machine's byte order
};

constexpr Scalar scalars[] = {
    {"char", "int8", 1, valueOf<std::int8_t>},    {"uchar", "uint8", 1, valueOf<std::uint8_t>},
    {"short", "int16", 2, valueOf<std::int16_t>}, {"ushort", "uint16", 2, valueOf<std::uint16_t>},
    {"int", "int32", 4, valueOf<std::int32_t>},   {"uint", "uint32", 4, valueOf<std::uint32_t>},
    {"float", "float32", 4, valueOf<float>},      {"double", "float64", 8, valueOf<double>}};

/// Returns nullptr for an unknown name.
const Scalar* scalarNamed(std::string_view name) {
    for (const auto& scalar : scalars)
        if (name == scalar.name || name == scalar.newName)
            return &scalar;
    return nullptr;
}

struct Property {
    std::string_view name;
    const Scalar* type = nullptr;
    const Scalar* countType = nullptr; ///< set for lists only

    const Scalar& firstType() const { return countType != nullptr ? *countType : *type; }
};

struct Element {
    std::string_view name;
    std::int64_t count = 0;
    std::vector<Property> properties;
};

struct Header {
    Encoding encoding = Encoding::text;
    std::vector<Element> elements;
};

/// Reads values in sequence, from text or bytes; nothing at the end of the file.
class Values {
public:
    Values(std::string_view body, Encoding encoding)
        : bytes_(body), text_(body), encoding_(encoding) {}

    std::optional<double> next(const Scalar& type) {
        if (encoding_ == Encoding::text)
            return text_.nextNumber();
        if (bytes_.size() < type.bytes)
            return std::nullopt;
        std::array<char, 8> raw{};
        std::copy_n(bytes_.begin(), type.bytes, raw.begin());
        bytes_.remove_prefix(type.bytes);
        if ((encoding_ == Encoding::bigEndian) != (std::endian::native == std::endian::big))
            std::reverse(raw.begin(), raw.begin() + type.bytes);
        return type.value(raw.data());
    }

    std::size_t bytesLeft() const {
        return encoding_ == Encoding::text ? text_.bytesLeft() : bytes_.size();
    }

    /// Returns the minimum number of bytes of a value.
    std::size_t minimumBytes(const Scalar& type) const {
        return encoding_ == Encoding::text ? 1 : type.bytes;
    }

private:
    std::string_view bytes_;
    TextScanner text_;
    Encoding encoding_;
};

std::optional<Property> readProperty(TextScanner& words) {
    Property property;
    auto type = words.nextWord();
    if (type == "list") {
        property.countType = scalarNamed(words.nextWord());
        if (property.countType == nullptr)
            return std::nullopt;
        type = words.nextWord();
    }
    property.type = scalarNamed(type);
    if (property.type == nullptr)
        return std::nullopt;
    property.name = words.nextWord();
    return property;
}

std::optional<Encoding> encodingNamed(std::string_view name) {
    if (name == "ascii")
        return Encoding::text;
    if (name == "binary_little_endian")
        return Encoding::littleEndian;
    if (name == "binary_big_endian")
        return Encoding::bigEndian;
    return std::nullopt;
}

Result<Header> readHeader(TextScanner& lines) {
    Header header;
    bool hasEncoding = false;
    while (const auto line = lines.nextLine()) {
        TextScanner words(*line);
        const auto keyword = words.nextWord();
        if (keyword == "end_header") {
            if (!hasEncoding)
                return failure("its header names no format");
            return header;
        }
        if (keyword == "format") {
            const auto encoding = encodingNamed(words.nextWord());
            if (!encoding)
                return failure("its header names a format that PLY does not have");
            header.encoding = *encoding;
            hasEncoding = true;
        } else if (keyword == "element") {
            const auto name = words.nextWord();
            const auto count = words.nextInteger();
            if (!count || *count < 0)
                return failure("its header gives an element without a valid count");
            header.elements.push_back({name, *count, {}});
        } else if (keyword == "property") {
            const auto property = readProperty(words);
            if (!property || header.elements.empty())
                return failure("its header has a property that cannot be understood");
            header.elements.back().properties.push_back(*property);
        }
    }
    return failure("its header does not end");
}

bool isPlausible(const Element& element, const Values& values) {
    std::size_t rowBytes = 0;
    for (const auto& property : element.properties)
        rowBytes += values.minimumBytes(property.firstType());
    return rowBytes == 0 ||
           static_cast<std::uint64_t>(element.count) <= values.bytesLeft() / rowBytes + 1;
}

/// Adds the triangles of strips, each of which ends at −1. Every second triangle is turned.
void addStrips(std::span<const std::int64_t> corners, RawMesh& mesh) {
    std::size_t begin = 0;
    for (std::size_t k = 0; k < corners.size(); ++k) {
        if (corners[k] < 0)
            begin = k + 1;
        else if (k >= begin + 2)
            mesh.addPolygon((k - begin) % 2 == 0
                                ? std::array{corners[k - 2], corners[k - 1], corners[k]}
                                : std::array{corners[k - 2], corners[k], corners[k - 1]});
    }
}

/// Reads one row of an element. Adds vertices and faces to the mesh and skips the rest. Returns
/// false at the end of the file.
bool readRow(const Element& element, Values& values, RawMesh& mesh) {
    const bool isVertex = element.name == "vertex", isFace = element.name == "face",
               isStrips = element.name == "tristrips";
    std::array<double, 3> position{};
    std::vector<std::int64_t> corners;
    for (const auto& property : element.properties) {
        const auto first = values.next(property.firstType());
        if (!first)
            return false;
        if (property.countType == nullptr) {
            if (isVertex && property.name.size() == 1 && property.name[0] >= 'x' &&
                property.name[0] <= 'z')
                position[property.name[0] - 'x'] = *first;
            continue;
        }
        const bool wanted = (isFace || isStrips) &&
                            (property.name == "vertex_indices" || property.name == "vertex_index");
        // Check before the cast: a hostile count may be negative, huge or NaN.
        if (!(*first >= 0 && *first <= static_cast<double>(values.bytesLeft())))
            return false;
        for (auto left = static_cast<std::int64_t>(*first); left > 0; --left) {
            const auto value = values.next(*property.type);
            if (!value)
                return false;
            if (wanted)
                corners.push_back(std::abs(*value) < 1e15 ? static_cast<std::int64_t>(*value) : -1);
        }
    }
    if (isVertex)
        mesh.coordinates.insert(mesh.coordinates.end(), position.begin(), position.end());
    if (isFace)
        mesh.addPolygon(corners);
    if (isStrips)
        addStrips(corners, mesh);
    return true;
}

} // namespace

Result<RawMesh> readPly(std::string_view bytes) {
    if (!bytes.starts_with("ply"))
        return failure("it does not begin with \"ply\"");
    auto lines = TextScanner::ofFile(bytes);
    const auto header = readHeader(lines);
    if (!header)
        return failure(header.error().message);
    Values values(bytes.substr(bytes.size() - lines.bytesLeft()), header->encoding);
    RawMesh mesh;
    for (const auto& element : header->elements) {
        if (!isPlausible(element, values))
            return failure("its header promises " + std::to_string(element.count) + " of element " +
                           inQuotes(element.name) + ", more than the file can hold");
        if (element.properties.empty())
            continue;
        for (std::int64_t row = 0; row < element.count; ++row)
            if (!readRow(element, values, mesh))
                return failure("it ends or is malformed at " + inQuotes(element.name) + " " +
                               std::to_string(row) + " of " + std::to_string(element.count));
    }
    return mesh;
}

} // namespace idiophone
