// SPDX-License-Identifier: Apache-2.0
#include "Gltf/PrincipalInertia.h"

#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>

namespace idiophone {

std::array<double, 9> inertiaMatrix(const PrincipalInertia& inertia) {
    using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
    const Eigen::Quaterniond turn(Eigen::Map<const Eigen::Vector4d>(inertia.orientation.data()));
    Eigen::Matrix3d axes = Eigen::Matrix3d::Identity();
    if (turn.norm() > 0)
        axes = turn.normalized().toRotationMatrix();
    const Eigen::Vector3d moments = Eigen::Map<const Eigen::Vector3d>(inertia.diagonalKgM2.data());
    std::array<double, 9> matrix;
    Eigen::Map<RowMajor>(matrix.data()) = axes * moments.asDiagonal() * axes.transpose();
    return matrix;
}

PrincipalInertia principalInertia(const std::array<double, 9>& matrix) {
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
        Eigen::Map<const Eigen::Matrix3d>(matrix.data()));
    Eigen::Matrix3d axes = solver.eigenvectors();
    if (axes.determinant() < 0)
        axes.col(2) = -axes.col(2);
    PrincipalInertia inertia;
    Eigen::Map<Eigen::Vector3d>(inertia.diagonalKgM2.data()) = solver.eigenvalues().cwiseMax(0);
    Eigen::Map<Eigen::Vector4d>(inertia.orientation.data()) =
        Eigen::Quaterniond(axes).normalized().coeffs();
    return inertia;
}

} // namespace idiophone
