#include "Analysis/ClosedSurface.h"

#include "Geometry/Remesh.h"
#include "Geometry/SurfaceQuery.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <map>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

using Edge = std::pair<int, int>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// [count] true for components with an edge that does not have exactly two faces.
std::vector<bool> openComponents(const Mesh& mesh, const Components& components) {
    std::vector<bool> isOpen(static_cast<std::size_t>(components.count), false);
    for (const auto& edge : uniqueEdges(mesh))
        if (edge.faceCount != 2)
            isOpen[static_cast<std::size_t>(
                components.componentOfVertex[static_cast<std::size_t>(edge.a)])] = true;
    return isOpen;
}

/// Collects the vertices and faces of a closed surface.
struct SurfaceBuilder {
    std::vector<Eigen::RowVector3d> vertices;
    std::vector<Eigen::RowVector3i> faces;
    Triplets motion;

    int add(const Eigen::RowVector3d& place) {
        vertices.push_back(place);
        return static_cast<int>(vertices.size()) - 1;
    }
    int add(const Eigen::RowVector3d& place, Eigen::Index movedBy) {
        const int vertex = add(place);
        motion.emplace_back(vertex, static_cast<int>(movedBy), 1.0);
        return vertex;
    }
};

/// Returns the boundary edges, directed as in their face. An edge counts once for each use that no
/// face of the opposite direction cancels.
std::vector<Edge> boundaryEdges(const std::vector<Eigen::RowVector3i>& faces) {
    std::map<Edge, int> uses;
    for (const auto& face : faces)
        for (int k = 0; k < 3; ++k) {
            const int a = face(k), b = face((k + 1) % 3);
            ++uses[{a, b}];
            --uses[{b, a}];
        }
    std::vector<Edge> edges;
    for (const auto& [edge, count] : uses)
        for (int use = 0; use < count; ++use)
            edges.push_back(edge);
    return edges;
}

/// Closes the gap between both sides along one edge, with a vertex in its middle.
void addRim(SurfaceBuilder& surface, Edge edge, Edge upper, Edge lower) {
    const auto place = [&](int vertex) {
        return surface.vertices[static_cast<std::size_t>(vertex)];
    };
    const int middle = surface.add(
        (place(upper.first) + place(upper.second) + place(lower.first) + place(lower.second)) / 4);
    surface.motion.emplace_back(middle, edge.first, 0.5);
    surface.motion.emplace_back(middle, edge.second, 0.5);
    surface.faces.emplace_back(upper.second, upper.first, middle);
    surface.faces.emplace_back(upper.first, lower.first, middle);
    surface.faces.emplace_back(lower.first, lower.second, middle);
    surface.faces.emplace_back(lower.second, upper.second, middle);
}

bool hasArea(const SurfaceBuilder& surface, const Eigen::RowVector3i& face) {
    const auto corner = [&](int k) { return surface.vertices[static_cast<std::size_t>(face(k))]; };
    const Eigen::RowVector3d first = corner(1) - corner(0), second = corner(2) - corner(0);
    constexpr double degenerate = 1e-9;
    return first.cross(second).norm() >
           degenerate * std::max({first.squaredNorm(), second.squaredNorm(),
                                  (second - first).squaredNorm()});
}

/// Makes the surface and removes faces without area.
ClosedSurface built(SurfaceBuilder builder, Eigen::Index movingVertices) {
    std::erase_if(builder.faces, [&](const auto& face) { return !hasArea(builder, face); });
    const auto vertexCount = static_cast<Eigen::Index>(builder.vertices.size());
    ClosedSurface surface{{Eigen::MatrixXd(vertexCount, 3),
                           Eigen::MatrixXi(static_cast<Eigen::Index>(builder.faces.size()), 3)},
                          Eigen::SparseMatrix<double>(vertexCount, movingVertices)};
    for (Eigen::Index vertex = 0; vertex < vertexCount; ++vertex)
        surface.mesh.vertices.row(vertex) = builder.vertices[static_cast<std::size_t>(vertex)];
    for (std::size_t face = 0; face < builder.faces.size(); ++face)
        surface.mesh.faces.row(static_cast<Eigen::Index>(face)) = builder.faces[face];
    surface.motion.setFromTriplets(builder.motion.begin(), builder.motion.end());
    return surface;
}

} // namespace

Eigen::MatrixXd ClosedSurface::normalShapes(const Eigen::MatrixXd& shapes) const {
    Triplets triplets;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        const auto corner = [&](int k) {
            return Eigen::RowVector3d(mesh.vertices.row(mesh.faces(face, k)));
        };
        const Eigen::RowVector3d normal =
            (corner(1) - corner(0)).cross(corner(2) - corner(0)).normalized();
        for (int k = 0; k < 3; ++k)
            for (int axis = 0; axis < 3; ++axis)
                triplets.emplace_back(static_cast<int>(face), 3 * mesh.faces(face, k) + axis,
                                      normal(axis) / 3);
    }
    Eigen::SparseMatrix<double> normals(mesh.faceCount(), 3 * mesh.vertexCount());
    normals.setFromTriplets(triplets.begin(), triplets.end());

    triplets.clear();
    for (int vertex = 0; vertex < motion.outerSize(); ++vertex)
        for (Eigen::SparseMatrix<double>::InnerIterator share(motion, vertex); share; ++share)
            for (int axis = 0; axis < 3; ++axis)
                triplets.emplace_back(3 * static_cast<int>(share.row()) + axis, 3 * vertex + axis,
                                      share.value());
    Eigen::SparseMatrix<double> displacements(3 * motion.rows(), 3 * motion.cols());
    displacements.setFromTriplets(triplets.begin(), triplets.end());
    const Eigen::SparseMatrix<double> both = normals * displacements;
    return both * shapes;
}

Result<ClosedSurface> closedSurface(const Mesh& mesh, double thicknessMetres) {
    const auto components = connectedComponents(mesh);
    const auto isOpen = openComponents(mesh, components);
    const auto isSheet = [&](Eigen::Index vertex) -> bool {
        return isOpen[static_cast<std::size_t>(
            components.componentOfVertex[static_cast<std::size_t>(vertex)])];
    };
    const Eigen::MatrixXd offsets = thicknessMetres / 2 * vertexNormals(mesh);

    SurfaceBuilder surface;
    std::vector<int> upper, lower; // indices on both sides; equal in closed components
    for (Eigen::Index vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        const Eigen::RowVector3d place = mesh.vertices.row(vertex);
        const Eigen::RowVector3d offset = offsets.row(vertex);
        upper.push_back(
            surface.add(isSheet(vertex) ? Eigen::RowVector3d(place + offset) : place, vertex));
        lower.push_back(isSheet(vertex) ? surface.add(place - offset, vertex) : upper.back());
    }
    const auto on = [](const std::vector<int>& side, int vertex) {
        return side[static_cast<std::size_t>(vertex)];
    };
    std::vector<Eigen::RowVector3i> sheetFaces;
    for (const auto& face : mesh.faces.rowwise()) {
        surface.faces.emplace_back(on(upper, face(0)), on(upper, face(1)), on(upper, face(2)));
        if (!isSheet(face(0)))
            continue;
        surface.faces.emplace_back(on(lower, face(2)), on(lower, face(1)), on(lower, face(0)));
        sheetFaces.emplace_back(face);
    }
    if (!sheetFaces.empty() && !(thicknessMetres > 0))
        return failure("An open surface needs a thickness to radiate from both of its sides.");
    for (const Edge& edge : boundaryEdges(sheetFaces))
        addRim(surface, edge, {on(upper, edge.first), on(upper, edge.second)},
               {on(lower, edge.first), on(lower, edge.second)});
    return built(std::move(surface), mesh.vertexCount());
}

ClosedSurface withFacesSplit(const ClosedSurface& surface) {
    const auto before = static_cast<int>(surface.mesh.vertexCount());
    Triplets triplets;
    for (int vertex = 0; vertex < before; ++vertex)
        triplets.emplace_back(vertex, vertex, 1.0);
    std::map<Edge, int> middles;
    const auto middle = [&](int a, int b) {
        const auto [at, isNew] =
            middles.try_emplace(std::minmax(a, b), before + static_cast<int>(middles.size()));
        if (isNew)
            for (const int end : {a, b})
                triplets.emplace_back(at->second, end, 0.5);
        return at->second;
    };
    ClosedSurface finer{{{}, Eigen::MatrixXi(4 * surface.mesh.faceCount(), 3)}, {}};
    for (Eigen::Index face = 0; face < surface.mesh.faceCount(); ++face) {
        const Eigen::RowVector3i corners = surface.mesh.faces.row(face);
        Eigen::RowVector3i between;
        for (int k = 0; k < 3; ++k)
            between(k) = middle(corners(k), corners((k + 1) % 3));
        for (int k = 0; k < 3; ++k)
            finer.mesh.faces.row(4 * face + k) << corners(k), between(k), between((k + 2) % 3);
        finer.mesh.faces.row(4 * face + 3) = between;
    }
    Eigen::SparseMatrix<double> split(before + static_cast<int>(middles.size()), before);
    split.setFromTriplets(triplets.begin(), triplets.end());
    finer.mesh.vertices = split * surface.mesh.vertices;
    finer.motion = split * surface.motion;
    return finer;
}

Result<ClosedSurface>
remeshed(const ClosedSurface& surface, double edgeLengthMetres, const WorkControl& control) {
    auto mesh = remesh(surface.mesh, {.edgeLengthMetres = edgeLengthMetres}, control);
    if (!mesh)
        return tl::unexpected(mesh.error());
    const SurfaceQuery query(surface.mesh);
    Triplets triplets;
    for (Eigen::Index vertex = 0; vertex < mesh->vertexCount(); ++vertex) {
        const auto nearest = query.nearestPoint(mesh->vertices.row(vertex).transpose());
        for (int k = 0; k < 3; ++k)
            triplets.emplace_back(static_cast<int>(vertex), surface.mesh.faces(nearest.face, k),
                                  nearest.barycentric(k));
    }
    Eigen::SparseMatrix<double> nearest(mesh->vertexCount(), surface.mesh.vertexCount());
    nearest.setFromTriplets(triplets.begin(), triplets.end());
    ClosedSurface result{std::move(*mesh), {}};
    result.motion = nearest * surface.motion;
    return result;
}

} // namespace idiophone
