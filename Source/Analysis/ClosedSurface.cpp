#include "Analysis/ClosedSurface.h"

#include "Geometry/MeshBuilder.h"
#include "Geometry/Remesh.h"
#include "Geometry/Subdivision.h"
#include "Mesh/SurfaceQuery.h"

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
    std::vector<bool> isOpen(components.count, false);
    for (const auto& edge : uniqueEdges(mesh))
        if (edge.faceCount != 2)
            isOpen[components.componentOfVertex[edge.a]] = true;
    return isOpen;
}

/// Collects a closed surface and its motion.
struct SurfaceBuilder : MeshBuilder {
    Triplets motion;

    using MeshBuilder::add;
    int add(const Eigen::RowVector3d& place, Eigen::Index movedBy) {
        const int vertex = add(place);
        motion.emplace_back(vertex, movedBy, 1.0);
        return vertex;
    }
};

/// Closes the gap between both sides along one edge, with a vertex in its middle.
void addRim(SurfaceBuilder& surface, Edge edge, Edge upper, Edge lower) {
    const auto place = [&](int vertex) { return surface.vertices[vertex]; };
    const int middle = surface.add(
        (place(upper.first) + place(upper.second) + place(lower.first) + place(lower.second)) / 4);
    surface.motion.emplace_back(middle, edge.first, 0.5);
    surface.motion.emplace_back(middle, edge.second, 0.5);
    surface.face(upper.second, upper.first, middle);
    surface.face(upper.first, lower.first, middle);
    surface.face(lower.first, lower.second, middle);
    surface.face(lower.second, upper.second, middle);
}

bool hasArea(const SurfaceBuilder& surface, const Eigen::RowVector3i& face) {
    const auto corner = [&](int k) { return surface.vertices[face(k)]; };
    const Eigen::RowVector3d first = corner(1) - corner(0), second = corner(2) - corner(0);
    constexpr double degenerate = 1e-9;
    return first.cross(second).norm() >
           degenerate * std::max({first.squaredNorm(), second.squaredNorm(),
                                  (second - first).squaredNorm()});
}

/// Makes the surface and removes faces without area.
ClosedSurface built(SurfaceBuilder builder, Eigen::Index movingVertices) {
    std::erase_if(builder.faces, [&](const auto& face) { return !hasArea(builder, face); });
    ClosedSurface surface{builder.mesh(),
                          Eigen::SparseMatrix<double>(builder.vertices.size(), movingVertices)};
    surface.motion.setFromTriplets(builder.motion.begin(), builder.motion.end());
    return surface;
}

} // namespace

std::vector<Edge> boundaryEdges(const Eigen::MatrixXi& faces) {
    std::map<Edge, int> uses;
    for (const auto& face : faces.rowwise())
        for (int k = 0; k < 3; ++k) {
            const int a = face(k), b = face((k + 1) % 3);
            ++uses[{a, b}];
            --uses[{b, a}];
        }
    std::vector<Edge> edges;
    for (const auto& [edge, count] : uses)
        edges.insert(edges.end(), std::max(count, 0), edge);
    return edges;
}

Eigen::MatrixXd ClosedSurface::normalShapes(const Eigen::MatrixXd& shapes) const {
    Triplets triplets;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        const Eigen::RowVector3d normal = doubleAreaVector(mesh, face).normalized();
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
        return isOpen[components.componentOfVertex[vertex]];
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
    MeshBuilder sheets;
    for (const auto& face : mesh.faces.rowwise()) {
        surface.face(upper[face(0)], upper[face(1)], upper[face(2)]);
        if (!isSheet(face(0)))
            continue;
        surface.face(lower[face(2)], lower[face(1)], lower[face(0)]);
        sheets.face(face(0), face(1), face(2));
    }
    if (!sheets.faces.empty() && !(thicknessMetres > 0))
        return failure("An open surface needs a thickness to radiate from both of its sides.");
    for (const Edge& edge : boundaryEdges(sheets.mesh().faces))
        addRim(surface, edge, {upper[edge.first], upper[edge.second]},
               {lower[edge.first], lower[edge.second]});
    return built(std::move(surface), mesh.vertexCount());
}

ClosedSurface withFacesSplit(const ClosedSurface& surface) {
    const FaceSplit split = splitInFour(surface.mesh);
    return {{split.vertices * surface.mesh.vertices, split.faces}, split.vertices * surface.motion};
}

Result<ClosedSurface>
remeshed(const ClosedSurface& surface, double edgeLengthMetres, const WorkControl& control) {
    auto mesh = remesh(surface.mesh, edgeLengthMetres, control);
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
