// SPDX-License-Identifier: Apache-2.0
#include "Mesh/Mesh.h"

#include "Mesh/DisjointSets.h"
#include "Mesh/FaceSides.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>

namespace idiophone {

Eigen::RowVector3d doubleAreaVector(const Mesh& mesh, Eigen::Index face) {
    const Eigen::RowVector3d a = mesh.vertices.row(mesh.faces(face, 0));
    const Eigen::RowVector3d b = mesh.vertices.row(mesh.faces(face, 1));
    const Eigen::RowVector3d c = mesh.vertices.row(mesh.faces(face, 2));
    return (b - a).cross(c - a);
}

Eigen::VectorXd faceAreas(const Mesh& mesh) {
    Eigen::VectorXd areas(mesh.faceCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        areas(face) = doubleAreaVector(mesh, face).norm() / 2;
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
        const Eigen::RowVector3d normal = doubleAreaVector(mesh, face);
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
    // Areas are summed in face order, so that the same mesh gives the same bits.
    for (const auto& side : sortedFaceSides(mesh)) {
        if (edges.empty() || edges.back().a != side.low || edges.back().b != side.high)
            edges.push_back({side.low, side.high, 0, 0});
        edges.back().faceCount += 1;
        edges.back().adjacentAreaM2 += areas(side.face);
    }
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

int nearestVertex(const Mesh& mesh, const Eigen::RowVector3d& pointMetres) {
    Eigen::Index nearest = 0;
    (mesh.vertices.rowwise() - pointMetres).rowwise().squaredNorm().minCoeff(&nearest);
    return static_cast<int>(nearest);
}

std::vector<int> allVertices(const Mesh& mesh) {
    std::vector<int> all(mesh.vertexCount());
    std::iota(all.begin(), all.end(), 0);
    return all;
}

Eigen::AlignedBox3d boxOfFaces(const Mesh& mesh) {
    Eigen::AlignedBox3d box;
    for (const int vertex : mesh.faces.reshaped())
        box.extend(mesh.vertices.row(vertex).transpose());
    return box;
}

double boundingDiagonalMetres(const Mesh& mesh) {
    if (mesh.vertexCount() == 0)
        return 0;
    return (mesh.vertices.colwise().maxCoeff() - mesh.vertices.colwise().minCoeff()).norm();
}

double signedVolumeM3(const Mesh& mesh) {
    if (mesh.vertexCount() == 0)
        return 0;
    // Measure from a point of the mesh: far from the origin the terms would cancel.
    const Eigen::RowVector3d origin = mesh.vertices.row(0);
    double sum = 0;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        sum += (mesh.vertices.row(mesh.faces(face, 0)) - origin).dot(doubleAreaVector(mesh, face));
    return sum / 6;
}

Components connectedComponents(const Mesh& mesh) {
    DisjointSets sets(mesh.vertexCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 1; corner < 3; ++corner)
            sets.join(mesh.faces(face, 0), mesh.faces(face, corner));
    Components components{.componentOfVertex = std::vector<int>(mesh.vertexCount()), .count = 0};
    for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        // The lowest vertex of a component already has its number.
        const int lowest = sets.nameOf(vertex);
        components.componentOfVertex[vertex] =
            lowest == vertex ? components.count++ : components.componentOfVertex[lowest];
    }
    return components;
}

} // namespace idiophone
