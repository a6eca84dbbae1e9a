#include "Analysis/SpringMassModel.h"

#include "Analysis/SpringAssembly.h"

namespace idiophone {
namespace {

/// Returns the stiffness in N/m.
double springStiffness(const MeshEdge& edge,
                       double lengthMetres,
                       double youngsModulusPa,
                       double thicknessMetres,
                       SpringStiffness stiffness) {
    const double k = youngsModulusPa * thicknessMetres;
    if (stiffness == SpringStiffness::literal)
        return k;
    return k * edge.adjacentAreaM2 / (lengthMetres * lengthMetres);
}

} // namespace

VibrationModel springMassModel(const Mesh& mesh,
                               const Material& material,
                               double thicknessMetres,
                               SpringStiffness stiffness) {
    const auto edges = uniqueEdges(mesh);
    SpringAssembly springs;
    springs.reserve(edges.size() * 21);
    for (const auto& edge : edges) {
        const Eigen::Vector3d along = mesh.vertices.row(edge.b) - mesh.vertices.row(edge.a);
        const double length = along.norm();
        const Eigen::Vector3d n = along / length;
        springs.add<2>(
            springStiffness(edge, length, material.youngsModulusPa, thicknessMetres, stiffness),
            {3 * edge.a, 3 * edge.b}, {-n, n});
    }
    const Eigen::VectorXd masses = material.densityKgPerM3 * thicknessMetres * vertexAreas(mesh);
    return {.stiffness = springs.matrix(3 * mesh.vertexCount()),
            .mass = diagonalMass(masses.transpose().replicate(3, 1).reshaped()),
            .rowsPerVertex = 3};
}

} // namespace idiophone
