#include "Analysis/QuadraticTetrahedra.h"

#include <Eigen/Geometry>
#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

namespace idiophone {
namespace {

using Element = Eigen::Matrix<double, 30, 30>;
using Corners = Eigen::Matrix<double, 4, 3>;
using Triplets = std::vector<Eigen::Triplet<double>>;

/// [10×4] derivatives of the shape functions L_i (2 L_i − 1) and 4 L_i L_j by the four barycentric
/// coordinates.
Eigen::Matrix<double, 10, 4> barycentricDerivatives(const Eigen::Vector4d& l) {
    Eigen::Matrix<double, 10, 4> d = Eigen::Matrix<double, 10, 4>::Zero();
    for (int i = 0; i < 4; ++i)
        d(i, i) = 4 * l(i) - 1;
    for (int edge = 0; edge < 6; ++edge) {
        const auto [i, j] = tetrahedronEdges[edge];
        d(4 + edge, i) = 4 * l(j);
        d(4 + edge, j) = 4 * l(i);
    }
    return d;
}

/// [4×3] gradients of the barycentric coordinates of a straight-sided element.
Eigen::Matrix<double, 4, 3> barycentricGradients(const Corners& corners) {
    Eigen::Matrix4d system;
    system << Eigen::Vector4d::Ones(), corners;
    return system.inverse().bottomRows<3>().transpose();
}

double signedVolumeM3(const Corners& corners) {
    const Eigen::Vector3d a = corners.row(1) - corners.row(0), b = corners.row(2) - corners.row(0),
                          c = corners.row(3) - corners.row(0);
    return a.cross(b).dot(c) / 6;
}

Eigen::Matrix<double, 6, 30> strainMatrix(const Eigen::Matrix<double, 10, 3>& gradients) {
    Eigen::Matrix<double, 6, 30> b = Eigen::Matrix<double, 6, 30>::Zero();
    for (int node = 0; node < 10; ++node)
        b.middleCols<3>(3 * node) = strainAlong(gradients.row(node).transpose());
    return b;
}

/// Adds the lower triangle of `element`. Each node has `Width` rows.
template <int Width, class Matrix>
void scatter(const Eigen::RowVectorXi& nodes, const Matrix& element, Triplets& triplets) {
    for (int p = 0; p < 10; ++p)
        for (int q = 0; q < 10; ++q)
            for (int i = 0; i < Width; ++i)
                for (int j = 0; j < Width; ++j) {
                    const int row = Width * nodes(p) + i, column = Width * nodes(q) + j;
                    if (row >= column)
                        triplets.emplace_back(row, column, element(Width * p + i, Width * q + j));
                }
}

Eigen::SparseMatrix<double> assembled(Eigen::Index rows, const Triplets& triplets) {
    Eigen::SparseMatrix<double> matrix(rows, rows);
    matrix.setFromTriplets(triplets.begin(), triplets.end());
    return matrix;
}

/// Repeats the mass for each of the three directions.
Eigen::SparseMatrix<double> threefold(const Eigen::SparseMatrix<double>& mass) {
    Eigen::SparseMatrix<double> result(3 * mass.rows(), 3 * mass.cols());
    result.reserve(3 * mass.nonZeros());
    for (Eigen::Index column = 0; column < mass.cols(); ++column)
        for (Eigen::Index axis = 0; axis < 3; ++axis) {
            result.startVec(3 * column + axis);
            for (Eigen::SparseMatrix<double>::InnerIterator it(mass, column); it; ++it)
                result.insertBack(3 * it.row() + axis, 3 * column + axis) = it.value();
        }
    result.finalize();
    return result;
}

/// The four points of Hammer, Marlowe & Stroud (1956), in barycentric coordinates.
Eigen::Vector4d integrationPoint(int point) {
    Eigen::Vector4d l = Eigen::Vector4d::Constant((5 - std::sqrt(5.0)) / 20);
    l(point) = (5 + 3 * std::sqrt(5.0)) / 20;
    return l;
}

/// Returns the straight element that has the same gradients as a curved one at a point.
Corners tangentElement(const ElementNodes& nodes, const Eigen::Vector4d& l) {
    return barycentricDerivatives(l).transpose() * nodes;
}

} // namespace

ElementNodes nodesOf(const TetMesh& mesh, Eigen::Index tetrahedron) {
    return mesh.nodes(mesh.tetrahedra.row(tetrahedron), Eigen::all);
}

double leastVolumeShare(const ElementNodes& nodes) {
    const double straight = signedVolumeM3(nodes.topRows<4>());
    double least = std::numeric_limits<double>::infinity();
    for (int point = 0; point < 4; ++point)
        for (const Eigen::Vector4d& l :
             {Eigen::Vector4d(Eigen::Vector4d::Unit(point)), integrationPoint(point)})
            least = std::min(least, signedVolumeM3(tangentElement(nodes, l)) / straight);
    return least;
}

ElementIntegrals elementIntegrals(const ElementNodes& nodesMetres, const ElasticLaw& law) {
    const Corners corners = nodesMetres.topRows<4>();
    const double straightM3 = std::abs(signedVolumeM3(corners));
    bool isStraight = true;
    for (int edge = 0; edge < 6; ++edge) {
        const auto [a, b] = tetrahedronEdges[edge];
        isStraight =
            isStraight && nodesMetres.row(4 + edge) == (corners.row(a) + corners.row(b)) / 2;
    }
    ElementIntegrals sums;
    for (int point = 0; point < 4; ++point) {
        const Eigen::Vector4d l = integrationPoint(point);
        const Corners tangent = isStraight ? corners : tangentElement(nodesMetres, l);
        const double share = isStraight ? 1 : std::abs(signedVolumeM3(tangent)) / straightM3;
        const auto strain = strainMatrix(barycentricDerivatives(l) * barycentricGradients(tangent));
        const Eigen::Matrix<double, 6, 30> stress = share * (law.stiffnessPa * strain);
        sums.stiffness.noalias() += strain.transpose() * stress;
        sums.volumeM3 += share * straightM3 / 4;
    }
    sums.stiffness *= straightM3 / 4;
    return sums;
}

Eigen::Matrix<double, 10, 10> elementMassShares() {
    Eigen::Matrix<double, 10, 10> shares = Eigen::Matrix<double, 10, 10>::Ones();
    shares.topLeftCorner<4, 4>().diagonal().setConstant(6);
    for (int p = 0; p < 6; ++p) {
        const auto [a, b] = tetrahedronEdges[p];
        for (int corner = 0; corner < 4; ++corner)
            shares(4 + p, corner) = shares(corner, 4 + p) = corner == a || corner == b ? -4 : -6;
        for (int q = 0; q < 6; ++q) {
            const auto [c, d] = tetrahedronEdges[q];
            const bool touching = a == c || a == d || b == c || b == d;
            shares(4 + p, 4 + q) = p == q ? 32 : touching ? 16 : 8;
        }
    }
    return shares / 420;
}

VibrationModel
quadraticTetrahedra(const TetMesh& mesh, const ElasticLaw& law, double densityKgPerM3) {
    const auto shares = elementMassShares();
    Triplets stiffness, mass;
    stiffness.reserve(static_cast<std::size_t>(mesh.tetrahedra.rows()) * 465);
    mass.reserve(static_cast<std::size_t>(mesh.tetrahedra.rows()) * 55);
    for (Eigen::Index t = 0; t < mesh.tetrahedra.rows(); ++t) {
        const auto integrals = elementIntegrals(nodesOf(mesh, t), law);
        const Eigen::RowVectorXi nodes = mesh.tetrahedra.row(t);
        scatter<3>(nodes, integrals.stiffness, stiffness);
        scatter<1>(nodes, (densityKgPerM3 * integrals.volumeM3 * shares).eval(), mass);
    }
    const Eigen::Index nodes = mesh.nodes.rows();
    return {.stiffness = assembled(3 * nodes, stiffness),
            .mass = threefold(assembled(nodes, mass)),
            .rowsPerVertex = 3};
}

} // namespace idiophone
