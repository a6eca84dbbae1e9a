// Builds a mesh vertex by vertex and face by face.
#pragma once

#include "Mesh/Mesh.h"

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

    /// Fills the band between two rows of vertices. Walks both rows and advances on the one whose
    /// next segment lies further back, which keeps the band symmetric. A Row has `steps()` segments
    /// between its `vertex(k)`, which lie at `place(k)` along it.
    template <class Row>
    void stitch(const Row& lower, const Row& upper) {
        constexpr double tie = 1e-9; // without it, rounding would decide and sectors would differ
        int i = 0, j = 0;
        while (i < lower.steps() || j < upper.steps())
            if (j == upper.steps() ||
                (i < lower.steps() &&
                 lower.place(i) + lower.place(i + 1) < upper.place(j) + upper.place(j + 1) + tie)) {
                face(lower.vertex(i), lower.vertex(i + 1), upper.vertex(j));
                ++i;
            } else {
                face(lower.vertex(i), upper.vertex(j + 1), upper.vertex(j));
                ++j;
            }
    }

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
