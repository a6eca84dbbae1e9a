#include "Geometry/MeshReader.h"

#include "Geometry/MeshFile.h"
#include "Geometry/PolygonTriangles.h"
#include "Object/FileBytes.h"
#include "Object/NumberText.h"
#include "Object/SameName.h"
#include "Object/TextFile.h"

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
            return read(withoutByteOrderMark(*bytes));
        }
    return failure("its extension is none of .obj, .off, .ply and .stl");
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

/// Cuts the polygons into triangles.
MeshOfFile triangulated(const RawMesh& raw) {
    MeshOfFile result{.mesh = {}, .notes = raw.notes};
    using RowMajor = Eigen::Matrix<double, Eigen::Dynamic, 3, Eigen::RowMajor>;
    const auto& vertices = result.mesh.vertices =
        Eigen::Map<const RowMajor>(raw.coordinates.data(), raw.vertexCount(), 3);
    std::vector<int> corners;
    corners.reserve(raw.corners.size());
    Eigen::MatrixX3d polygon;
    int guesses = 0;
    for (std::size_t index = 0; index < raw.polygonEnds.size(); ++index) {
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
