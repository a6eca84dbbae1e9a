#include "Geometry/MeshReader.h"

#include "Geometry/MeshFile.h"
#include "Geometry/PolygonTriangles.h"
#include "Gltf/GltfFile.h"
#include "Object/ByteOrderMark.h"
#include "Object/FileBytes.h"
#include "Object/NumberText.h"
#include "Object/OneLine.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <span>
#include <string>

namespace idiophone {
namespace {

constexpr std::uintmax_t largestFileBytes = std::uintmax_t{2} << 30;
constexpr double largestUnits = 1e6;

constexpr std::array<std::pair<std::string_view, Result<RawMesh> (*)(std::string_view)>, 4> formats{
    {{".obj", readObj}, {".off", readOff}, {".ply", readPly}, {".stl", readStl}}};

Result<RawMesh> readRawMesh(const std::filesystem::path& file) {
    if (!isMeshFile(file))
        return failure("its extension is none of .obj, .off, .ply, .stl, .gltf and .glb");
    const auto bytes = readBytes(file, largestFileBytes);
    if (!bytes)
        return failure(bytes.error().message);
    if (bytes->empty())
        return failure("it is empty");
    const auto content = withoutByteOrderMark(*bytes);
    if (isGltfFile(file))
        return readGltf(content, file.parent_path());
    return std::ranges::find_if(
               formats, [&](const auto& format) { return hasExtension(file, format.first); })
        ->second(content);
}

/// Returns the first fault of the whole mesh; empty if there is none.
std::string faultOf(const RawMesh& raw) {
    if (raw.corners.empty())
        return "it has no faces";
    // Face corners and coordinates are counted in int. A polygon has fewer triangles than corners.
    if (raw.coordinates.size() > std::numeric_limits<int>::max())
        return "it has too many vertices";
    if (raw.corners.size() > std::numeric_limits<int>::max() / 3)
        return "it has too many faces";
    Eigen::AlignedBox3d box; // polygons of larger numbers would overflow
    for (const auto vertex : raw.corners) {
        if (vertex < 0 || vertex >= raw.vertexCount())
            return "a face names a vertex that does not exist (there are " +
                   std::to_string(raw.vertexCount()) + " vertices)";
        const auto place =
            std::span(raw.coordinates).subspan(static_cast<std::size_t>(vertex) * 3, 3);
        if (!std::ranges::all_of(place, [](double x) { return std::isfinite(x); }))
            return numbered("vertex", vertex) + " is not a finite number";
        box.extend(Eigen::Vector3d(place[0], place[1], place[2]));
    }
    if (!(box.sizes().maxCoeff() <= largestUnits))
        return "its faces reach over more than a million units of length";
    return {};
}

std::span<const std::int64_t> polygonOf(const RawMesh& raw, std::size_t polygon) {
    const auto begin = polygon == 0 ? 0 : raw.polygonEnds[polygon - 1];
    return std::span(raw.corners).subspan(begin, raw.polygonEnds[polygon] - begin);
}

/// Returns the groups with the triangles of their polygons. Polygon p has the triangles from
/// firstTriangles[p] up to the next polygon's.
std::vector<MeshGroup> groupsOf(const std::vector<RawGroup>& raw,
                                const std::vector<int>& firstTriangles) {
    std::vector<MeshGroup> groups;
    for (const auto& [name, polygons] : raw) {
        MeshGroup group{.name = name, .faces = {}};
        for (const auto polygon : polygons)
            for (int face = firstTriangles[polygon]; face < firstTriangles[polygon + 1]; ++face)
                group.faces.push_back(face);
        if (!group.faces.empty())
            groups.push_back(std::move(group));
    }
    return groups;
}

/// Cuts the polygons into triangles.
MeshOfFile triangulated(const RawMesh& raw) {
    MeshOfFile result{.mesh = {}, .notes = raw.notes, .isInMetres = raw.isInMetres};
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
    const auto& vertices = result.mesh.vertices =
        Eigen::Map<const RowMajor>(raw.coordinates.data(), raw.vertexCount(), 3);
    std::vector<int> corners;
    corners.reserve(raw.corners.size());
    Eigen::MatrixX3d polygon;
    int guesses = 0;
    std::vector<int> firstTriangles;
    for (std::size_t index = 0; index < raw.polygonEnds.size(); ++index) {
        firstTriangles.push_back(static_cast<int>(corners.size() / 3));
        const auto ofPolygon = polygonOf(raw, index);
        if (ofPolygon.size() == 3) {
            corners.insert(corners.end(), ofPolygon.begin(), ofPolygon.end());
            continue;
        }
        polygon.resize(static_cast<Eigen::Index>(ofPolygon.size()), 3);
        for (Eigen::Index row = 0; row < polygon.rows(); ++row)
            polygon.row(row) = vertices.row(ofPolygon[static_cast<std::size_t>(row)]);
        const auto triangles = trianglesOf(polygon);
        guesses += triangles.isGuess ? 1 : 0;
        for (const auto& triangle : triangles.corners)
            for (const int corner : triangle)
                corners.push_back(static_cast<int>(ofPolygon[static_cast<std::size_t>(corner)]));
    }
    firstTriangles.push_back(static_cast<int>(corners.size() / 3));
    result.groups = groupsOf(raw.groups, firstTriangles);
    using RowMajorIndices = Eigen::Matrix<int, Eigen::Dynamic, 3, Eigen::RowMajor>;
    result.mesh.faces = Eigen::Map<const RowMajorIndices>(
        corners.data(), static_cast<Eigen::Index>(corners.size() / 3), 3);
    if (guesses > 0)
        result.notes += (result.notes.empty() ? "" : " ") +
                        (guesses == 1 ? "One polygon crosses itself: its triangles are a guess."
                                      : std::to_string(guesses) +
                                            " polygons cross themselves: their triangles are a "
                                            "guess.");
    return result;
}

/// Moves a mesh far from the origin there, with a note.
void moveNear(MeshOfFile& file) {
    constexpr double farDiagonals = 100, coarseShare = 1e-4;
    auto& vertices = file.mesh.vertices;
    const auto box = boxOfFaces(file.mesh);
    const double diagonal = box.diagonal().norm();
    const double distance =
        std::max(box.min().cwiseAbs().maxCoeff(), box.max().cwiseAbs().maxCoeff());
    if (distance <= farDiagonals * diagonal && distance <= largestUnits)
        return;
    const Eigen::RowVector3d centre = (box.min() + box.sizes() / 2).transpose();
    file.notes +=
        (file.notes.empty() ? "" : " ") + std::string("Moved the mesh to the origin from ");
    for (int axis = 0; axis < 3; ++axis)
        file.notes += (axis == 0 ? "(" : ", ") + numberText(centre(axis));
    file.notes += "), in units of the file.";
    const double step = distance * std::numeric_limits<float>::epsilon();
    if (vertices == vertices.cast<float>().cast<double>() && step > coarseShare * diagonal)
        file.notes += " So far away, numbers in single precision are rounded to " +
                      numberText(step, 1) + ": save the mesh near the origin.";
    vertices.rowwise() -= centre;
}

/// Moves vertices that are no numbers or far away to a vertex with a face. Only vertices without a
/// face can be.
void gatherStrays(Mesh& mesh) {
    const Eigen::RowVector3d place = mesh.vertices.row(mesh.faces(0, 0));
    for (auto vertex : mesh.vertices.rowwise())
        if (!(vertex.cwiseAbs().maxCoeff<Eigen::PropagateNaN>() <= largestUnits))
            vertex = place;
}

} // namespace

bool isMeshFile(const std::filesystem::path& file) {
    return isGltfFile(file) || std::ranges::any_of(formats, [&](const auto& format) {
               return hasExtension(file, format.first);
           });
}

Result<const MeshGroup*> findGroup(const std::vector<MeshGroup>& groups, std::string_view name) {
    constexpr std::size_t namesShown = 12;
    const auto found = std::ranges::find(groups, name, &MeshGroup::name);
    if (found != groups.end())
        return &*found;
    std::string sentence = "There is no group " + inQuotes(name) + " in the mesh; ";
    if (groups.empty())
        return failure(sentence + "its faces have no names.");
    sentence += groups.size() == 1 ? "its only group is " : "its groups are ";
    for (std::size_t i = 0; i < std::min(groups.size(), namesShown); ++i)
        sentence += (i == 0 ? "" : ", ") + inQuotes(groups[i].name);
    if (groups.size() > namesShown)
        sentence += " and " + std::to_string(groups.size() - namesShown) + " more";
    return failure(sentence + ".");
}

Result<MeshOfFile> readMeshFile(const std::filesystem::path& file, double metresPerUnit) {
    const auto fail = [&](const std::string& fault) {
        return failure("The mesh file \"" + nameOf(file) + "\" cannot be used: " + fault + ".");
    };
    if (!(metresPerUnit > 0) || !std::isfinite(metresPerUnit))
        return fail("its unit must be a positive number of metres");
    try {
        const auto raw = readRawMesh(file);
        if (!raw)
            return fail(raw.error().message);
        if (const auto fault = faultOf(*raw); !fault.empty())
            return fail(fault);
        auto read = triangulated(*raw);
        moveNear(read);
        gatherStrays(read.mesh);
        read.mesh.vertices *= metresPerUnit;
        return read;
    } catch (const std::bad_alloc&) {
        return fail("it is too large for this machine's memory");
    }
}

Result<Mesh> readMesh(const std::filesystem::path& file, double metresPerUnit) {
    return readMeshFile(file, metresPerUnit).transform([](MeshOfFile&& read) {
        return std::move(read.mesh);
    });
}

} // namespace idiophone
