#include "Geometry/MeshRepair.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <igl/remove_duplicate_vertices.h>
#include <numeric>
#include <tuple>

namespace idiophone {
namespace {

/// Numbers the classes of equal vertices in order of their first member.
std::vector<int> numberedInOrder(const std::vector<int>& classOfVertex, int& count) {
    std::vector<int> numberOfClass(classOfVertex.size(), -1), result;
    result.reserve(classOfVertex.size());
    count = 0;
    for (const int c : classOfVertex) {
        if (numberOfClass[c] < 0)
            numberOfClass[c] = count++;
        result.push_back(numberOfClass[c]);
    }
    return result;
}

/// For each vertex the number of the vertex that it is welded into.
std::vector<int> weldClasses(const Eigen::MatrixXd& vertices, double cellMetres, int& count) {
    std::vector<int> classes(static_cast<std::size_t>(vertices.rows()));
    std::iota(classes.begin(), classes.end(), 0);
    count = static_cast<int>(classes.size());
    // libigl rounds to a grid: two vertices on either side of a cell's border stay two. A second
    // pass on a grid shifted by half a cell joins those.
    Eigen::MatrixXd current = vertices;
    for (const double shift : {0.0, 0.5}) {
        const Eigen::MatrixXd shifted = current.array() + shift * cellMetres;
        Eigen::MatrixXd unique;
        Eigen::VectorXi representative, classOf;
        igl::remove_duplicate_vertices(shifted, cellMetres / 10, unique, representative, classOf);
        const auto numbers = numberedInOrder({classOf.begin(), classOf.end()}, count);
        for (int& c : classes)
            c = numbers[c];
        Eigen::MatrixXd next(count, 3);
        for (Eigen::Index i = current.rows() - 1; i >= 0; --i)
            next.row(numbers[i]) = current.row(i); // the first member is written last, and stays
        current = std::move(next);
    }
    return classes;
}

bool isDegenerate(const Mesh& mesh, const Eigen::RowVector3i& face) {
    if (face(0) == face(1) || face(1) == face(2) || face(2) == face(0))
        return true;
    const Eigen::RowVector3d u = mesh.vertices.row(face(1)) - mesh.vertices.row(face(0));
    const Eigen::RowVector3d v = mesh.vertices.row(face(2)) - mesh.vertices.row(face(0));
    const double longest = std::max({u.squaredNorm(), v.squaredNorm(), (u - v).squaredNorm()});
    return u.cross(v).norm() <= 1e-10 * longest;
}

void keepRows(Eigen::MatrixXi& faces, const std::vector<char>& keep) {
    Eigen::Index kept = 0;
    for (Eigen::Index face = 0; face < faces.rows(); ++face)
        if (keep[face])
            faces.row(kept++) = faces.row(face).eval();
    faces.conservativeResize(kept, Eigen::NoChange);
}

void dropDegenerateFaces(Mesh& mesh, RepairReport& report) {
    std::vector<char> keep(mesh.faceCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        keep[face] = !isDegenerate(mesh, mesh.faces.row(face));
    report.degenerateFaces = static_cast<int>(std::ranges::count(keep, 0));
    keepRows(mesh.faces, keep);
}

void dropDuplicateFaces(Mesh& mesh, RepairReport& report) {
    std::vector<std::array<int, 4>> keys(mesh.faceCount()); // three sorted corners, face
    for (int face = 0; face < static_cast<int>(keys.size()); ++face) {
        keys[face] = {mesh.faces(face, 0), mesh.faces(face, 1), mesh.faces(face, 2), face};
        std::sort(keys[face].begin(), keys[face].begin() + 3);
    }
    std::ranges::sort(keys);
    std::vector<char> keep(keys.size(), 1);
    for (std::size_t i = 1; i < keys.size(); ++i)
        if (std::equal(keys[i].begin(), keys[i].begin() + 3, keys[i - 1].begin()))
            keep[keys[i][3]] = 0;
    report.duplicateFaces = static_cast<int>(std::ranges::count(keep, 0));
    keepRows(mesh.faces, keep);
}

void keepLargestComponent(Mesh& mesh, RepairReport& report) {
    const auto components = connectedComponents(mesh);
    const auto areas = faceAreas(mesh);
    std::vector<double> areaOf(components.count, 0);
    std::vector<char> hasFaces(components.count, 0);
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        const int component = components.componentOfVertex[mesh.faces(face, 0)];
        areaOf[component] += areas(face);
        hasFaces[component] = 1;
    }
    const auto largest = std::ranges::max_element(areaOf) - areaOf.begin();
    std::vector<char> keep(mesh.faceCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        keep[face] = components.componentOfVertex[mesh.faces(face, 0)] == largest;
    report.droppedComponents = static_cast<int>(std::ranges::count(hasFaces, 1)) - 1;
    keepRows(mesh.faces, keep);
}

/// Drops vertices of no face; returns for each old vertex its new number or −1.
std::vector<int> dropUnreferenced(Mesh& mesh, RepairReport& report) {
    std::vector<int> newNumber(mesh.vertexCount(), -1);
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner)
            newNumber[mesh.faces(face, corner)] = 0;
    int count = 0;
    for (Eigen::Index vertex = 0; vertex < mesh.vertexCount(); ++vertex)
        if (newNumber[vertex] == 0) {
            newNumber[vertex] = count;
            mesh.vertices.row(count++) = mesh.vertices.row(vertex).eval();
        }
    report.unreferencedVertices = static_cast<int>(mesh.vertexCount()) - count;
    mesh.vertices.conservativeResize(count, Eigen::NoChange);
    mesh.faces = mesh.faces.unaryExpr([&](int vertex) { return newNumber[vertex]; }).eval();
    return newNumber;
}

/// Across an edge of exactly two faces: the other face, and whether both run along it the same way.
struct Neighbour {
    int face = -1;
    bool sameDirection = false;
};

struct FaceAdjacency {
    std::vector<std::array<Neighbour, 3>> neighbours;
    std::vector<char> touchesBoundary; ///< or an edge of more than two faces
};

FaceAdjacency faceAdjacency(const Mesh& mesh, RepairReport& report) {
    struct HalfEdge {
        int low, high, face, corner;
        bool ascending;
    };
    std::vector<HalfEdge> halfEdges;
    halfEdges.reserve(static_cast<std::size_t>(mesh.faceCount()) * 3);
    for (int face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            const int a = mesh.faces(face, corner), b = mesh.faces(face, (corner + 1) % 3);
            halfEdges.push_back({std::min(a, b), std::max(a, b), face, corner, a < b});
        }
    std::ranges::sort(halfEdges, {}, [](const HalfEdge& h) {
        return std::tuple{h.low, h.high, h.face};
    });
    FaceAdjacency result{.neighbours = std::vector<std::array<Neighbour, 3>>(mesh.faceCount()),
                         .touchesBoundary = std::vector<char>(mesh.faceCount(), 0)};
    for (std::size_t i = 0, end = 0; i < halfEdges.size(); i = end) {
        while (end < halfEdges.size() && halfEdges[end].low == halfEdges[i].low &&
               halfEdges[end].high == halfEdges[i].high)
            ++end;
        if (end - i == 2) {
            const auto &first = halfEdges[i], &second = halfEdges[i + 1];
            const bool same = first.ascending == second.ascending;
            result.neighbours[first.face][first.corner] = {second.face, same};
            result.neighbours[second.face][second.corner] = {first.face, same};
            continue;
        }
        (end - i == 1 ? report.boundaryEdges : report.nonManifoldEdges) += 1;
        for (std::size_t k = i; k < end; ++k)
            result.touchesBoundary[halfEdges[k].face] = 1;
    }
    return result;
}

double volumeOf(const Mesh& mesh, const std::vector<int>& faces, const std::vector<char>& flip) {
    const Eigen::RowVector3d origin = mesh.vertices.row(mesh.faces(faces.front(), 0));
    double sum = 0;
    for (const int face : faces) {
        const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(face, 0)) - origin;
        const Eigen::RowVector3d b = mesh.vertices.row(mesh.faces(face, 1)) - origin;
        const Eigen::RowVector3d c = mesh.vertices.row(mesh.faces(face, 2)) - origin;
        sum += (flip[face] ? -1 : 1) * a.dot(b.cross(c));
    }
    return sum;
}

void orientFaces(Mesh& mesh, RepairReport& report) {
    const auto adjacency = faceAdjacency(mesh, report);
    std::vector<char> seen(mesh.faceCount(), 0), flip(mesh.faceCount(), 0);
    for (int seed = 0; seed < mesh.faceCount(); ++seed) {
        if (seen[seed])
            continue;
        std::vector<int> patch{seed};
        seen[seed] = 1;
        bool closed = true;
        for (std::size_t next = 0; next < patch.size(); ++next) {
            const int face = patch[next];
            closed = closed && !adjacency.touchesBoundary[face];
            for (const auto& neighbour : adjacency.neighbours[face])
                if (neighbour.face >= 0 && !seen[neighbour.face]) {
                    seen[neighbour.face] = 1;
                    flip[neighbour.face] = flip[face] != neighbour.sameDirection;
                    patch.push_back(neighbour.face);
                }
        }
        const auto flips = std::ranges::count_if(patch, [&](int face) { return flip[face] != 0; });
        // Outward where that means something; otherwise the side that most faces already show.
        const bool turn = closed ? volumeOf(mesh, patch, flip) < 0
                                 : 2 * flips > static_cast<std::ptrdiff_t>(patch.size());
        for (const int face : patch)
            if ((flip[face] != 0) != turn) {
                std::swap(mesh.faces(face, 1), mesh.faces(face, 2));
                ++report.flippedFaces;
            }
    }
}

} // namespace

bool RepairReport::changedAnything() const {
    return weldedVertices + degenerateFaces + duplicateFaces + unreferencedVertices + flippedFaces +
               droppedComponents >
           0;
}

std::string RepairReport::text() const {
    std::string text;
    const auto say = [&](int count, const char* before, const char* one, const char* many) {
        if (count > 0)
            text += std::string(text.empty() ? "" : " ") + before + std::to_string(count) + " " +
                    (count == 1 ? one : many) + ".";
    };
    say(weldedVertices, "Welded ", "vertex", "vertices");
    say(degenerateFaces, "Dropped ", "degenerate face", "degenerate faces");
    say(duplicateFaces, "Dropped ", "duplicate face", "duplicate faces");
    say(unreferencedVertices, "Dropped ", "vertex of no face", "vertices of no face");
    say(droppedComponents, "Dropped ", "smaller component", "smaller components");
    say(flippedFaces, "Turned ", "face over", "faces over");
    say(boundaryEdges, "Open: ", "boundary edge", "boundary edges");
    say(nonManifoldEdges, "Not a manifold: ", "edge of more than two faces",
        "edges of more than two faces");
    if (components > 1)
        say(components, "", "component", "components that do not touch");
    return text;
}

Result<RepairedMesh> repairMesh(const Mesh& input, const RepairSettings& settings) {
    if (input.faceCount() == 0)
        return failure("The mesh has no faces.");
    if (!input.vertices.allFinite())
        return failure("The mesh has a vertex that is not a finite number.");
    if (input.vertices.cols() != 3 || input.faces.cols() != 3 || input.faces.minCoeff() < 0 ||
        input.faces.maxCoeff() >= input.vertexCount())
        return failure("The mesh has a face that names a vertex that does not exist.");

    RepairedMesh result{.mesh = input, .report = {}, .vertexOfInput = {}};
    auto& [mesh, report, vertexOfInput] = result;
    const double cell = std::max(settings.weldTolerance, 1e-12) * boundingDiagonalMetres(input);
    if (!(cell > 0))
        return failure("The mesh has all its vertices in one point.");
    int count = 0;
    vertexOfInput = weldClasses(input.vertices, cell, count);
    report.weldedVertices = static_cast<int>(input.vertexCount()) - count;
    for (Eigen::Index vertex = input.vertexCount() - 1; vertex >= 0; --vertex)
        mesh.vertices.row(vertexOfInput[vertex]) = input.vertices.row(vertex);
    mesh.vertices.conservativeResize(count, Eigen::NoChange);
    mesh.faces = mesh.faces.unaryExpr([&](int vertex) { return vertexOfInput[vertex]; }).eval();

    dropDegenerateFaces(mesh, report);
    dropDuplicateFaces(mesh, report);
    if (mesh.faceCount() == 0)
        return failure("The mesh has no face with an area.");
    if (settings.largestComponentOnly)
        keepLargestComponent(mesh, report);
    const auto newNumber = dropUnreferenced(mesh, report);
    for (int& vertex : vertexOfInput)
        vertex = newNumber[vertex];
    report.components = connectedComponents(mesh).count;
    orientFaces(mesh, report);
    return result;
}

} // namespace idiophone
