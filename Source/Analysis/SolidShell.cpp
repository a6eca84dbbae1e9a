#include "Analysis/SolidShell.h"

#include "Analysis/AnalysisMethod.h"
#include "Analysis/QuadraticTetrahedra.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <map>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

using Edge = std::pair<int, int>;

/// Returns the outer and inner side of the wall and the rims along the middle surface's boundary.
Mesh wallSurface(const Mesh& middle, const Eigen::VectorXd& thicknessMetres) {
    const auto count = static_cast<int>(middle.vertexCount());
    const Eigen::MatrixXd offsets = (0.5 * thicknessMetres).asDiagonal() * vertexNormals(middle);
    std::map<Edge, int> directed;
    std::vector<Eigen::RowVector3i> faces;
    for (const auto& face : middle.faces.rowwise()) {
        faces.emplace_back(face);
        faces.emplace_back(face(2) + count, face(1) + count, face(0) + count);
        for (int k = 0; k < 3; ++k)
            ++directed[{face(k), face((k + 1) % 3)}];
    }
    for (const auto& [edge, uses] : directed) {
        const auto [a, b] = edge;
        if (directed.contains({b, a}))
            continue;
        faces.emplace_back(b, a, a + count);
        faces.emplace_back(b, a + count, b + count);
    }
    Mesh surface{Eigen::MatrixXd(2 * count, 3),
                 Eigen::MatrixXi(static_cast<Eigen::Index>(faces.size()), 3)};
    surface.vertices << middle.vertices + offsets, middle.vertices - offsets;
    for (std::size_t face = 0; face < faces.size(); ++face)
        surface.faces.row(static_cast<Eigen::Index>(face)) = faces[face];
    return surface;
}

/// Returns three tetrahedra over a triangle of the middle surface. The walls between prisms are cut
/// from the inner corner of the lower number to the outer corner of the higher one. So neighbours
/// agree.
std::array<std::array<int, 4>, 3> prismCorners(Eigen::RowVector3i triangle, int count) {
    std::sort(triangle.begin(), triangle.end());
    const int a = triangle(0), b = triangle(1), c = triangle(2);
    const auto inner = [&](int vertex) { return vertex + count; };
    return {{{inner(a), inner(b), inner(c), c}, {inner(a), inner(b), b, c}, {inner(a), a, b, c}}};
}

TetMesh wallElements(const Mesh& middle, const Mesh& surface) {
    const auto count = static_cast<int>(middle.vertexCount());
    std::vector<Eigen::RowVector3d> nodes(surface.vertices.rowwise().begin(),
                                          surface.vertices.rowwise().end());
    std::map<Edge, int> middles;
    const auto midNode = [&](int a, int b) {
        const auto [place, isNew] = middles.try_emplace(std::minmax(a, b), 0);
        if (isNew) {
            place->second = static_cast<int>(nodes.size());
            const Eigen::RowVector3d centre =
                (nodes[static_cast<std::size_t>(a)] + nodes[static_cast<std::size_t>(b)]) / 2;
            nodes.push_back(centre);
        }
        return place->second;
    };
    TetMesh elements{.nodes = {},
                     .tetrahedra = Eigen::MatrixXi(3 * middle.faceCount(), 10),
                     .surfaceVertexCount = 2 * count};
    Eigen::Index row = 0;
    for (const auto& triangle : middle.faces.rowwise())
        for (auto corners : prismCorners(triangle, count)) {
            Eigen::Matrix3d edges;
            for (int k = 0; k < 3; ++k)
                edges.row(k) = surface.vertices.row(corners[static_cast<std::size_t>(k) + 1]) -
                               surface.vertices.row(corners[0]);
            if (edges.determinant() < 0)
                std::swap(corners[1], corners[2]);
            for (int k = 0; k < 4; ++k)
                elements.tetrahedra(row, k) = corners[static_cast<std::size_t>(k)];
            for (std::size_t e = 0; e < tetrahedronEdges.size(); ++e) {
                const auto [a, b] = tetrahedronEdges[e];
                elements.tetrahedra(row, 4 + static_cast<Eigen::Index>(e)) = midNode(
                    corners[static_cast<std::size_t>(a)], corners[static_cast<std::size_t>(b)]);
            }
            ++row;
        }
    elements.nodes.resize(static_cast<Eigen::Index>(nodes.size()), 3);
    for (std::size_t node = 0; node < nodes.size(); ++node)
        elements.nodes.row(static_cast<Eigen::Index>(node)) = nodes[node];
    return elements;
}

} // namespace

BodyModel
solidShell(const Mesh& middle, const Eigen::VectorXd& thicknessMetres, const Material& material) {
    BodyModel body;
    body.surface = wallSurface(middle, thicknessMetres);
    const TetMesh elements = wallElements(middle, body.surface);
    body.model = quadraticTetrahedra(elements, elasticLaw(material), material.densityKgPerM3);
    body.pointsMetres = elements.nodes;
    body.body = BodyKind::solid;
    body.material = material;
    body.method = methodName(AnalysisMethod::tetrahedra);
    return body;
}

} // namespace idiophone
