// Builds a mesh vertex by vertex and face by face.
#pragma once

#include "Geometry/Mesh.h"

#include <vector>

namespace idiophone {

struct MeshBuilder {
    std::vector<Eigen::RowVector3d> vertices; ///< in metres
    std::vector<Eigen::RowVector3i> faces;

    /// Adds a vertex and returns its index.
    int add(const Eigen::RowVector3d& place) {
        vertices.push_back(place);
        return static_cast<int>(vertices.size()) - 1;
    }
    int add(double x, double y, double z) { return add({x, y, z}); }
    void face(int a, int b, int c) { faces.emplace_back(a, b, c); }

    Mesh mesh() const {
        Mesh result{Eigen::MatrixXd(vertices.size(), 3), Eigen::MatrixXi(faces.size(), 3)};
        for (std::size_t i = 0; i < vertices.size(); ++i)
            result.vertices.row(i) = vertices[i];
        for (std::size_t i = 0; i < faces.size(); ++i)
            result.faces.row(i) = faces[i];
        return result;
    }
};

} // namespace idiophone
