#include "Analysis/SolidShell.h"

#include "Analysis/AnalysisMethod.h"
#include "Analysis/ClosedSurface.h"
#include "Analysis/QuadraticTetrahedra.h"
#include "Geometry/MeshBuilder.h"

#include <Eigen/LU>
#include <algorithm>
#include <array>
#include <utility>

namespace idiophone {
namespace {

/// Returns the outer and inner side of the wall and the rims along the middle surface's boundary.
Mesh wallSurface(const Mesh& middle, const Eigen::VectorXd& thicknessMetres) {
    const auto count = static_cast<int>(middle.vertexCount());
    const Eigen::MatrixXd offsets = (0.5 * thicknessMetres).asDiagonal() * vertexNormals(middle);
    MeshBuilder surface;
    for (const auto& face : middle.faces.rowwise()) {
        surface.face(face(0), face(1), face(2));
        surface.face(face(2) + count, face(1) + count, face(0) + count);
    }
    for (const auto& [a, b] : boundaryEdges(middle.faces)) {
        surface.face(b, a, a + count);
        surface.face(b, a + count, b + count);
    }
    Mesh mesh = surface.mesh();
    mesh.vertices.resize(2 * count, 3);
    mesh.vertices << middle.vertices + offsets, middle.vertices - offsets;
    return mesh;
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
    Eigen::MatrixXi tetrahedra(3 * middle.faceCount(), 4);
    Eigen::Index row = 0;
    for (const auto& triangle : middle.faces.rowwise())
        for (auto corners : prismCorners(triangle, count)) {
            Eigen::Matrix3d edges;
            for (int k = 0; k < 3; ++k)
                edges.row(k) =
                    surface.vertices.row(corners[k + 1]) - surface.vertices.row(corners[0]);
            if (edges.determinant() < 0)
                std::swap(corners[1], corners[2]);
            tetrahedra.row(row++) = Eigen::RowVector4i(corners.data());
        }
    return withMidEdgeNodes(surface.vertices, tetrahedra, 2 * count);
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
