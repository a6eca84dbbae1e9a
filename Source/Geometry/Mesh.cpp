#include "Geometry/Mesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <numeric>

namespace idiophone {
namespace {

/// The face's normal with the length of twice its area.
Eigen::RowVector3d areaVector(const Mesh& mesh, Eigen::Index face) {
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(face, 0));
    const Eigen::RowVector3d b = mesh.vertices.row(mesh.faces(face, 1));
    const Eigen::RowVector3d c = mesh.vertices.row(mesh.faces(face, 2));
    return (b - a).cross(c - a);
}

int rootOf(std::vector<int>& parents, int vertex) {
    while (parents[vertex] != vertex) {
        parents[vertex] = parents[parents[vertex]];
        vertex = parents[vertex];
    }
    return vertex;
}

} // namespace

Eigen::VectorXd faceAreas(const Mesh& mesh) {
    Eigen::VectorXd areas(mesh.faceCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        areas(face) = areaVector(mesh, face).norm() / 2;
    return areas;
}

Eigen::VectorXd vertexAreas(const Mesh& mesh) {
    const Eigen::VectorXd areas = faceAreas(mesh);
    Eigen::VectorXd sums = Eigen::VectorXd::Zero(mesh.vertexCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner)
            sums(mesh.faces(face, corner)) += areas(face) / 3;
    return sums;
}

Eigen::MatrixXd vertexNormals(const Mesh& mesh) {
    Eigen::MatrixXd normals = Eigen::MatrixXd::Zero(mesh.vertexCount(), 3);
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        const Eigen::RowVector3d normal = areaVector(mesh, face);
        for (int corner = 0; corner < 3; ++corner)
            normals.row(mesh.faces(face, corner)) += normal;
    }
    for (Eigen::Index vertex = 0; vertex < normals.rows(); ++vertex) {
        const double length = normals.row(vertex).norm();
        if (length > 0)
            normals.row(vertex) /= length;
        else
            normals.row(vertex) = Eigen::RowVector3d::UnitZ();
    }
    return normals;
}

std::vector<MeshEdge> uniqueEdges(const Mesh& mesh) {
    const Eigen::VectorXd areas = faceAreas(mesh);
    std::vector<MeshEdge> edges;
    edges.reserve(static_cast<std::size_t>(mesh.faceCount()) * 3);
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner) {
            const auto [a, b] =
                std::minmax({mesh.faces(face, corner), mesh.faces(face, (corner + 1) % 3)});
            edges.push_back({a, b, 1, areas(face)});
        }
    // Stable, so that areas add up in the order of the faces: the same mesh, the same bits.
    std::ranges::stable_sort(edges, {}, [](const MeshEdge& e) { return std::array{e.a, e.b}; });
    std::size_t last = 0;
    for (std::size_t i = 1; i < edges.size(); ++i) {
        if (edges[i].a == edges[last].a && edges[i].b == edges[last].b) {
            edges[last].faceCount += 1;
            edges[last].adjacentAreaM2 += edges[i].adjacentAreaM2;
        } else {
            edges[++last] = edges[i];
        }
    }
    if (!edges.empty())
        edges.resize(last + 1);
    return edges;
}

double meanEdgeLengthMetres(const Mesh& mesh) {
    const auto edges = uniqueEdges(mesh);
    double sum = 0;
    for (const auto& edge : edges)
        sum += (mesh.vertices.row(edge.a) - mesh.vertices.row(edge.b)).norm();
    return edges.empty() ? 0 : sum / static_cast<double>(edges.size());
}

bool isClosed(const std::vector<MeshEdge>& edges) {
    return !edges.empty() &&
           std::ranges::all_of(edges, [](const MeshEdge& e) { return e.faceCount == 2; });
}

double boundingDiagonalMetres(const Mesh& mesh) {
    if (mesh.vertexCount() == 0)
        return 0;
    return (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).norm();
}

double signedVolumeM3(const Mesh& mesh) {
    if (mesh.vertexCount() == 0)
        return 0;
    // About a point of the mesh: far from the origin the terms would cancel.
    const Eigen::RowVector3d origin = mesh.vertices.row(0);
    double sum = 0;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        sum += (mesh.vertices.row(mesh.faces(face, 0)) - origin).dot(areaVector(mesh, face));
    return sum / 6;
}

Components connectedComponents(const Mesh& mesh) {
    std::vector<int> parents(static_cast<std::size_t>(mesh.vertexCount()));
    std::iota(parents.begin(), parents.end(), 0);
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 1; corner < 3; ++corner) {
            const auto [low, high] = std::minmax(
                {rootOf(parents, mesh.faces(face, 0)), rootOf(parents, mesh.faces(face, corner))});
            parents[high] = low;
        }
    Components components{.componentOfVertex = std::vector<int>(parents.size()), .count = 0};
    for (int vertex = 0; vertex < static_cast<int>(parents.size()); ++vertex) {
        // The root is the lowest vertex of its component, so it has been numbered before.
        const int root = rootOf(parents, vertex);
        components.componentOfVertex[vertex] =
            root == vertex ? components.count++ : components.componentOfVertex[root];
    }
    return components;
}

} // namespace idiophone
