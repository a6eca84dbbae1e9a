// SPDX-License-Identifier: Apache-2.0
#include "Mesh/ShapeMesh.h"

#include "Mesh/ObjectMesh.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cstdint>
#include <functional>
#include <igl/adjacency_list.h>
#include <queue>
#include <set>
#include <tuple>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

using Triple = std::array<std::int32_t, 3>;

// The circumradius of Delaunay triangles of evenly spread points is less than their spacing.
constexpr double largestReach = 1.5; // spacings

/// The row of each vertex; −1 if no row can be reached along edges.
struct Cells {
    std::vector<std::int32_t> rowOfVertex;
    std::vector<double> distanceMetres; ///< distance of each vertex to its row's vertex
};

/// Grows cells from the rows along edges, nearest vertex first, so that each cell is connected.
Cells voronoiCells(const Mesh& mesh, const Mesh& shapes, const ModalObject& object) {
    std::vector<std::vector<int>> neighbours;
    if (mesh.faceCount() > 0)
        igl::adjacency_list(mesh.faces, neighbours);
    const auto vertexCount = static_cast<std::size_t>(mesh.vertexCount());
    neighbours.resize(vertexCount);

    using Claim = std::tuple<double, std::int32_t, int>; // distance, row, vertex
    std::priority_queue<Claim, std::vector<Claim>, std::greater<>> claims;
    for (std::size_t row = 0; row < object.shapeVertexCount(); ++row)
        claims.emplace(0, static_cast<std::int32_t>(row), object.shapeVertices[row]);
    Cells cells{.rowOfVertex = std::vector<std::int32_t>(vertexCount, -1),
                .distanceMetres = std::vector<double>(vertexCount, 0)};
    while (!claims.empty()) {
        const auto [distance, row, vertex] = claims.top();
        claims.pop();
        const auto index = static_cast<std::size_t>(vertex);
        if (cells.rowOfVertex[index] >= 0)
            continue;
        cells.rowOfVertex[index] = row;
        cells.distanceMetres[index] = distance;
        for (const int next : neighbours[index])
            if (cells.rowOfVertex[next] < 0)
                claims.emplace((mesh.vertices.row(next) - shapes.vertices.row(row)).norm(), row,
                               next);
    }
    return cells;
}

struct CellFace {
    Triple rows;
    double reachMetres; ///< maximum distance of the face's corners to their rows' vertices
};

/// Returns the object's faces with the rows of their corners.
std::vector<CellFace> cellFaces(const Mesh& mesh, const Cells& cells) {
    std::vector<CellFace> faces;
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        CellFace result{.rows = {}, .reachMetres = 0};
        for (int corner = 0; corner < 3; ++corner) {
            const auto vertex = static_cast<std::size_t>(mesh.faces(face, corner));
            result.rows[corner] = cells.rowOfVertex[vertex];
            result.reachMetres = std::max(result.reachMetres, cells.distanceMetres[vertex]);
        }
        faces.push_back(result);
    }
    return faces;
}

/// Returns each row's median distance to the rows of adjacent cells. Long lines of rows and cells
/// that reach far around the object hardly change the median.
std::vector<double> spacings(const std::vector<CellFace>& faces, const Mesh& shapes) {
    std::set<std::pair<std::int32_t, std::int32_t>> adjacent;
    for (const auto& [rows, reach] : faces)
        for (std::size_t corner = 0; corner < 3; ++corner)
            if (const auto a = rows[corner], b = rows[(corner + 1) % 3]; a != b && a >= 0 && b >= 0)
                adjacent.insert({{a, b}, {b, a}});
    std::vector<double> spacing(shapes.vertexCount(), 0.0);
    std::vector<double> metres;
    for (auto first = adjacent.begin(), end = first; first != adjacent.end(); first = end) {
        metres.clear();
        for (; end != adjacent.end() && end->first == first->first; ++end)
            metres.push_back(
                (shapes.vertices.row(end->first) - shapes.vertices.row(end->second)).norm());
        const auto middle = metres.begin() + static_cast<std::ptrdiff_t>(metres.size() / 2);
        std::ranges::nth_element(metres, middle);
        spacing[first->first] = *middle;
    }
    return spacing;
}

/// Returns true if a face between three rows looks to the outside of the surface. `normals` [V,3].
bool facesOut(const Triple& rows, const Mesh& shapes, const Eigen::MatrixXd& normals) {
    const Eigen::RowVector3d a = shapes.vertices.row(rows[0]), b = shapes.vertices.row(rows[1]),
                             c = shapes.vertices.row(rows[2]);
    const Eigen::RowVector3d outward =
        normals.row(rows[0]) + normals.row(rows[1]) + normals.row(rows[2]);
    return (b - a).cross(c - a).dot(outward) > 0;
}

/// Returns the triples of rows whose cells meet within reach, each once.
std::vector<Triple>
meetings(const std::vector<CellFace>& faces, const Mesh& shapes, const Eigen::MatrixXd& normals) {
    const auto spacing = spacings(faces, shapes);
    std::vector<Triple> found;
    for (auto [rows, reach] : faces) {
        if (rows[0] == rows[1] || rows[1] == rows[2] || rows[2] == rows[0] ||
            *std::ranges::min_element(rows) < 0)
            continue;
        double widest = 0;
        for (const auto row : rows)
            widest = std::max(widest, spacing[row]);
        const bool isOwnFace = reach == 0;
        if (!isOwnFace && (reach > largestReach * widest || !facesOut(rows, shapes, normals)))
            continue;
        std::ranges::rotate(rows, std::ranges::min_element(rows));
        found.push_back(rows);
    }
    std::ranges::sort(found);
    const auto repeated = std::ranges::unique(found);
    found.erase(repeated.begin(), repeated.end());
    return found;
}

} // namespace

Mesh shapeMesh(const ModalObject& object) {
    const auto mesh = objectMesh(object);
    const auto rowCount = static_cast<Eigen::Index>(object.shapeVertexCount());
    Mesh shapes;
    shapes.vertices.resize(rowCount, 3);
    const Eigen::MatrixXd meshNormals = vertexNormals(mesh);
    Eigen::MatrixXd normals(rowCount, 3);
    for (Eigen::Index row = 0; row < rowCount; ++row) {
        const auto vertex = object.shapeVertices[row];
        shapes.vertices.row(row) = mesh.vertices.row(vertex);
        normals.row(row) = meshNormals.row(vertex);
    }

    auto triples = meetings(cellFaces(mesh, voronoiCells(mesh, shapes, object)), shapes, normals);
    std::vector<bool> hasFace(object.shapeVertexCount(), false);
    for (const auto& rows : triples)
        for (const auto row : rows)
            hasFace[row] = true;
    for (std::int32_t row = 0; row < rowCount; ++row)
        if (!hasFace[row])
            triples.push_back({row, row, row});

    shapes.faces.resize(triples.size(), 3);
    for (std::size_t face = 0; face < triples.size(); ++face)
        for (std::size_t corner = 0; corner < 3; ++corner)
            shapes.faces(face, corner) = triples[face][corner];
    return shapes;
}

} // namespace idiophone
