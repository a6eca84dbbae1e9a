#include "Analysis/TwoLayerShell.h"

#include "Analysis/SpringAssembly.h"
#include "Analysis/TimoshenkoBeam.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>

namespace idiophone {
namespace {

/// Returns the shear stiffness κ G t of the sheet in N/m, softened by the bending within one edge
/// (MacNeal's residual bending flexibility, L²/12D). Without this softening, coarse meshes of thin
/// shells lock.
double shearStiffness(const Material& material, double thicknessMetres, double lengthMetres) {
    const double nu = material.poissonRatio, y = material.youngsModulusPa;
    const double pure = rectangularShearCoefficient(nu) * y / (2 * (1 + nu)) * thicknessMetres;
    const double bending = y * std::pow(thicknessMetres, 3) / 12;
    return 1 / (1 / pure + lengthMetres * lengthMetres / (12 * bending));
}

struct Layers {
    Eigen::MatrixXd upper, lower; ///< [N×3]
};

void addBraces(SpringAssembly& springs,
               const Layers& layers,
               const MeshEdge& edge,
               double lengthMetres,
               double sheetShearStiffness) {
    const auto unit = [](const Eigen::Vector3d& v) { return Eigen::Vector3d(v / v.norm()); };
    const Eigen::Vector3d down = (layers.lower.row(edge.b) - layers.upper.row(edge.a)).transpose();
    const Eigen::Vector3d up = (layers.upper.row(edge.b) - layers.lower.row(edge.a)).transpose();
    const double brace2 = (down.squaredNorm() + up.squaredNorm()) / 2;
    const double height2 = ((layers.upper.row(edge.a) - layers.lower.row(edge.a)).squaredNorm() +
                            (layers.upper.row(edge.b) - layers.lower.row(edge.b)).squaredNorm()) /
                           2;
    // A shear strain γ along the edge makes the elongations differ by 2 γ L H/ℓ. On equilateral
    // triangles, edges of stiffness (2/3) S (A1+A2)/L² against L γ make a sheet of shear stiffness
    // S.
    const double edgeStiffness =
        2.0 / 3 * sheetShearStiffness * edge.adjacentAreaM2 / (lengthMetres * lengthMetres);
    const Eigen::Vector3d n1 = unit(down), n2 = unit(up);
    springs.add<4>(edgeStiffness * brace2 / (4 * height2),
                   {6 * edge.a, 6 * edge.a + 3, 6 * edge.b, 6 * edge.b + 3}, {-n1, n2, -n2, n1});
}

/// Adds the plane-stress triangle of one strain as three springs, each acting on all three corners.
/// One resists the change of area, and two resist the change of shape. On an equilateral triangle
/// with ν = 1/3 they equal three springs along the edges, which are not isotropic on other
/// triangles.
void addTriangle(SpringAssembly& springs,
                 const Eigen::MatrixXd& points,
                 const Eigen::RowVector3i& corners,
                 int layer,
                 const Material& material,
                 double thicknessMetres) {
    const auto point = [&](int k) { return Eigen::Vector3d(points.row(corners(k % 3))); };
    const Eigen::Vector3d doubleArea = (point(1) - point(0)).cross(point(2) - point(0));
    const double area = doubleArea.norm() / 2;
    const Eigen::Vector3d normal = doubleArea / (2 * area);
    const Eigen::Vector3d e1 = (point(1) - point(0)).normalized(), e2 = normal.cross(e1);
    std::array<int, 3> rows{};
    std::array<Eigen::Vector3d, 3> areaChange, stretch, shear;
    for (int k = 0; k < 3; ++k) {
        rows[k] = 6 * corners(k) + 3 * layer;
        const Eigen::Vector3d gradient = normal.cross(point(k + 2) - point(k + 1)) / (2 * area);
        const double g1 = gradient.dot(e1), g2 = gradient.dot(e2);
        areaChange[k] = gradient;
        stretch[k] = g1 * e1 - g2 * e2;
        shear[k] = g2 * e1 + g1 * e2;
    }
    const double nu = material.poissonRatio;
    const double perStrain2 = material.youngsModulusPa * thicknessMetres * area / 2;
    springs.add<3>(perStrain2 / (1 - nu), rows, areaChange);
    springs.add<3>(perStrain2 / (1 + nu), rows, stretch);
    springs.add<3>(perStrain2 / (1 + nu), rows, shear);
}

} // namespace

double layerOffsetMetres(double thicknessMetres) {
    return thicknessMetres / std::sqrt(12.0);
}

VibrationModel twoLayerShell(const Mesh& mesh, const Material& material, double thicknessMetres) {
    const auto edges = uniqueEdges(mesh);
    const Eigen::VectorXd areas = vertexAreas(mesh);
    const Eigen::MatrixXd normals = vertexNormals(mesh);
    const double offset = layerOffsetMetres(thicknessMetres);
    const Layers layers{mesh.vertices + offset * normals, mesh.vertices - offset * normals};

    SpringAssembly springs;
    springs.reserve(edges.size() * 120 + static_cast<std::size_t>(mesh.vertexCount()) * 21);
    for (const auto& edge : edges) {
        const double length = (mesh.vertices.row(edge.b) - mesh.vertices.row(edge.a)).norm();
        addBraces(springs, layers, edge, length, shearStiffness(material, thicknessMetres, length));
    }
    for (const auto face : mesh.faces.rowwise())
        for (const auto layer : {0, 1})
            addTriangle(springs, layer == 0 ? layers.upper : layers.lower, face, layer, material,
                        thicknessMetres / 2);
    for (int v = 0; v < mesh.vertexCount(); ++v) {
        const Eigen::Vector3d n = normals.row(v);
        springs.add<2>(material.youngsModulusPa * areas(v) / (2 * offset), {6 * v, 6 * v + 3},
                       {n, -n});
    }
    const Eigen::VectorXd halves = material.densityKgPerM3 * thicknessMetres / 2 * areas;
    return {.stiffness = springs.matrix(6 * mesh.vertexCount()),
            .mass = diagonalMass(halves.transpose().replicate(6, 1).reshaped()),
            .rowsPerVertex = 6};
}

Eigen::MatrixXd midSurfaceShapes(const Eigen::MatrixXd& shapes) {
    const Eigen::Index vertices = shapes.rows() / 6;
    Eigen::MatrixXd middle(3 * vertices, shapes.cols());
    for (Eigen::Index v = 0; v < vertices; ++v)
        middle.middleRows(3 * v, 3) =
            (shapes.middleRows(6 * v, 3) + shapes.middleRows(6 * v + 3, 3)) / 2;
    return middle;
}

} // namespace idiophone
