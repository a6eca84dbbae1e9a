#include "Analysis/ElasticLaw.h"

#include "Geometry/ParametricMesh.h"

#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

namespace idiophone {
namespace {

constexpr std::array<std::pair<int, int>, 6> voigt{
    {{0, 0}, {1, 1}, {2, 2}, {1, 2}, {0, 2}, {0, 1}}};

Matrix6d complianceAlongAxes(const OrthotropicElasticity& e) {
    Matrix6d s = Matrix6d::Zero();
    s(0, 0) = 1 / e.youngsModulusLPa;
    s(1, 1) = 1 / e.youngsModulusRPa;
    s(2, 2) = 1 / e.youngsModulusTPa;
    s(0, 1) = s(1, 0) = -e.poissonRatioLR / e.youngsModulusLPa;
    s(0, 2) = s(2, 0) = -e.poissonRatioLT / e.youngsModulusLPa;
    s(1, 2) = s(2, 1) = -e.poissonRatioRT / e.youngsModulusRPa;
    s(3, 3) = 1 / e.shearModulusRTPa;
    s(4, 4) = 1 / e.shearModulusLTPa;
    s(5, 5) = 1 / e.shearModulusLRPa;
    return s;
}

/// Bond's matrix: turns Voigt stresses along the columns of `axes` into stresses along x, y, z.
Matrix6d stressRotation(const Eigen::Matrix3d& axes) {
    Matrix6d rotation;
    for (int column = 0; column < 6; ++column) {
        const auto [a, b] = voigt[column];
        Eigen::Matrix3d stress = Eigen::Matrix3d::Zero();
        stress(a, b) = stress(b, a) = 1;
        const Eigen::Matrix3d turned = axes * stress * axes.transpose();
        for (int row = 0; row < 6; ++row)
            rotation(row, column) = turned(voigt[row].first, voigt[row].second);
    }
    return rotation;
}

/// Returns L, R and T as columns.
Eigen::Matrix3d orthonormal(const GrainAxes& axes) {
    const Eigen::Vector3d grain = axes.grain.normalized();
    const Eigen::Vector3d wanted =
        axes.radial
            .value_or(std::abs(grain.z()) > 0.99 ? Eigen::Vector3d::UnitY()
                                                 : Eigen::Vector3d::UnitZ())
            .normalized();
    const Eigen::Vector3d across = (wanted - wanted.dot(grain) * grain).normalized();
    Eigen::Matrix3d result;
    result << grain, across, grain.cross(across);
    return result;
}

Matrix6d alongAxes(const OrthotropicElasticity& elasticity, const Eigen::Matrix3d& axes) {
    const Matrix6d local = complianceAlongAxes(elasticity).llt().solve(Matrix6d::Identity());
    const Matrix6d rotation = stressRotation(axes);
    const Matrix6d global = rotation * local * rotation.transpose();
    return (global + global.transpose()) / 2;
}

/// [642×3] unit vectors in all directions. The axes are among them or within 6° of one.
Eigen::MatrixXd allDirections() {
    return icosphereMesh(1, 3).vertices;
}

} // namespace

Eigen::Matrix<double, 6, 3> strainAlong(const Eigen::Vector3d& n) {
    Eigen::Matrix<double, 6, 3> b = Eigen::Matrix<double, 6, 3>::Zero();
    b(0, 0) = b(4, 2) = b(5, 1) = n.x();
    b(1, 1) = b(3, 2) = b(5, 0) = n.y();
    b(2, 2) = b(3, 1) = b(4, 0) = n.z();
    return b;
}

ElasticLaw elasticLaw(const OrthotropicElasticity& elasticity, const GrainAxes& axes) {
    return {alongAxes(elasticity, orthonormal(axes))};
}

ElasticLaw elasticLaw(const Material& material, const GrainAxes& axes) {
    if (material.grain)
        return elasticLaw(orthotropicElasticity(material.youngsModulusPa, *material.grain), axes);
    return {alongAxes(isotropicElasticity(material.youngsModulusPa, material.poissonRatio),
                      Eigen::Matrix3d::Identity())};
}

double slowestShearSpeedMetresPerSecond(const ElasticLaw& law, double densityKgPerM3) {
    double least = std::numeric_limits<double>::infinity();
    const Eigen::MatrixXd directions = allDirections();
    for (const auto& direction : directions.rowwise()) {
        const auto b = strainAlong(direction.transpose());
        const Eigen::Matrix3d christoffel = b.transpose() * law.stiffnessPa * b;
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(christoffel,
                                                                    Eigen::EigenvaluesOnly);
        least = std::min(least, solver.eigenvalues()(0));
    }
    return std::sqrt(least / densityKgPerM3);
}

double minimumYoungsModulusPa(const ElasticLaw& law) {
    const Matrix6d compliance = law.stiffnessPa.llt().solve(Matrix6d::Identity());
    double greatest = 0;
    const Eigen::MatrixXd directions = allDirections();
    for (const auto& n : directions.rowwise()) {
        Eigen::Matrix<double, 6, 1> stress; // unit tension along n
        stress << n(0) * n(0), n(1) * n(1), n(2) * n(2), n(1) * n(2), n(0) * n(2), n(0) * n(1);
        greatest = std::max(greatest, stress.dot(compliance * stress));
    }
    return 1 / greatest;
}

} // namespace idiophone
