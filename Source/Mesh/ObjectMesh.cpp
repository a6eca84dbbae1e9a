// SPDX-License-Identifier: Apache-2.0
#include "Mesh/ObjectMesh.h"

#include <cmath>
#include <cstdint>
#include <igl/PI.h>
#include <igl/per_corner_normals.h>
#include <igl/per_face_normals.h>
#include <igl/vertex_triangle_adjacency.h>
#include <span>
#include <vector>

namespace idiophone {
namespace {

using Coordinates = Eigen::Matrix<float, Eigen::Dynamic, 3, Eigen::RowMajor>;
using Corners = Eigen::Matrix<std::int32_t, Eigen::Dynamic, 3, Eigen::RowMajor>;

/// Sets the corner normals at these vertices to the mean over all faces around. If the mean turns
/// too far from the corner's own face, uses the face's normal.
void smoothCrowded(const Mesh& mesh,
                   const Eigen::MatrixXd& faceNormals,
                   std::span<const std::size_t> vertices,
                   double minimumCosine,
                   Eigen::MatrixXd& normals) {
    std::vector<char> isCrowded(mesh.vertexCount(), 0);
    for (const auto vertex : vertices)
        isCrowded[vertex] = 1;
    Eigen::MatrixXd mean = Eigen::MatrixXd::Zero(mesh.vertexCount(), 3);
    for (const bool isSum : {true, false})
        for (Eigen::Index corner = 0; corner < normals.rows(); ++corner) {
            const auto face = corner / 3, vertex = Eigen::Index{mesh.faces(face, corner % 3)};
            const Eigen::RowVector3d own = faceNormals.row(face);
            if (isCrowded[vertex] == 0 || !own.allFinite())
                continue;
            if (isSum) {
                mean.row(vertex) += own;
                continue;
            }
            const Eigen::RowVector3d smooth = mean.row(vertex).normalized();
            normals.row(corner) = smooth.dot(own) > minimumCosine ? smooth : own;
        }
}

} // namespace

Mesh objectMesh(const ModalObject& object) {
    const auto vertexCount = static_cast<Eigen::Index>(object.vertexCount());
    const auto faceCount = static_cast<Eigen::Index>(object.faceCount());
    return {
        .vertices =
            Eigen::Map<const Coordinates>(object.vertices.data(), vertexCount, 3).cast<double>(),
        .faces = Eigen::Map<const Corners>(object.faces.data(), faceCount, 3)};
}

void setMesh(ModalObject& object, const Mesh& mesh) {
    object.vertices.resize(mesh.vertices.size());
    object.faces.resize(mesh.faces.size());
    Eigen::Map<Coordinates>(object.vertices.data(), mesh.vertexCount(), 3) =
        mesh.vertices.cast<float>();
    Eigen::Map<Corners>(object.faces.data(), mesh.faceCount(), 3) = mesh.faces;
}

Eigen::MatrixXd cornerNormals(const Mesh& mesh, double creaseDegrees) {
    // per_corner_normals compares each corner with every face around it: quadratic if many faces
    // meet in one vertex.
    constexpr std::size_t maximumFacesAround = 64;
    std::vector<std::vector<int>> around, cornersAround;
    igl::vertex_triangle_adjacency(mesh.vertices, mesh.faces, around, cornersAround);
    std::vector<std::size_t> crowded;
    for (std::size_t vertex = 0; vertex < around.size(); ++vertex)
        if (around[vertex].size() > maximumFacesAround) {
            crowded.push_back(vertex);
            around[vertex].clear();
        }
    Eigen::MatrixXd faceNormals, normals;
    igl::per_face_normals(mesh.vertices, mesh.faces, faceNormals);
    igl::per_corner_normals(mesh.vertices, mesh.faces, faceNormals, around, creaseDegrees, normals);
    if (!crowded.empty())
        smoothCrowded(mesh, faceNormals, crowded, std::cos(creaseDegrees * igl::PI / 180), normals);
    for (Eigen::Index corner = 0; corner < normals.rows(); ++corner)
        if (!normals.row(corner).allFinite())
            normals.row(corner).setZero();
    return normals;
}

} // namespace idiophone
