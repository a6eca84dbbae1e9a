#include "Analysis/TimoshenkoBeam.h"

#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

/// The shape functions of an element's ends and middle at ξ in −1 … 1.
Eigen::Vector3d shapesAt(double xi) {
    return {xi * (xi - 1) / 2, 1 - xi * xi, xi * (xi + 1) / 2};
}

Eigen::Vector3d slopesAt(double xi) {
    return {xi - 0.5, -2 * xi, xi + 0.5};
}

struct QuadraturePoint {
    double xi, weight;
};

const std::array reduced{QuadraturePoint{-1 / std::sqrt(3.0), 1},
                         QuadraturePoint{1 / std::sqrt(3.0), 1}};
const std::array full{QuadraturePoint{-std::sqrt(0.6), 5.0 / 9}, QuadraturePoint{0, 8.0 / 9},
                      QuadraturePoint{std::sqrt(0.6), 5.0 / 9}};

using ElementMatrix = Eigen::Matrix<double, 6, 6>;
using ElementRow = Eigen::Matrix<double, 6, 1>;

/// Returns a row with the deflection and rotation of each of the three nodes in turn.
ElementRow interleaved(const Eigen::Vector3d& deflection, const Eigen::Vector3d& rotation) {
    ElementRow row;
    for (Eigen::Index node = 0; node < 3; ++node)
        row.segment<2>(2 * node) << deflection(node), rotation(node);
    return row;
}

} // namespace

std::vector<double> freeBeamFrequenciesHz(std::span<const double> nodesMetres,
                                          const std::function<BeamSection(double)>& sectionAt,
                                          int count) {
    const auto elements = static_cast<Eigen::Index>(nodesMetres.size()) - 1;
    const Eigen::Index rows = 2 * (2 * elements + 1);
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(rows, rows), mass = stiffness;
    const Eigen::Vector3d none = Eigen::Vector3d::Zero();
    for (Eigen::Index e = 0; e < elements; ++e) {
        const double start = nodesMetres[e];
        const double half = (nodesMetres[e + 1] - start) / 2;
        ElementMatrix k = ElementMatrix::Zero(), m = k;
        for (const auto& point : reduced) {
            const BeamSection section = sectionAt(start + half * (1 + point.xi));
            const ElementRow curvature = interleaved(none, slopesAt(point.xi) / half);
            const ElementRow shear = interleaved(slopesAt(point.xi) / half, -shapesAt(point.xi));
            k += point.weight * half *
                 (section.bendingStiffnessNM2 * curvature * curvature.transpose() +
                  section.shearStiffnessN * shear * shear.transpose());
        }
        for (const auto& point : full) {
            const BeamSection section = sectionAt(start + half * (1 + point.xi));
            const ElementRow deflection = interleaved(shapesAt(point.xi), none);
            const ElementRow rotation = interleaved(none, shapesAt(point.xi));
            m += point.weight * half *
                 (section.massKgPerM * deflection * deflection.transpose() +
                  section.rotaryInertiaKgM * rotation * rotation.transpose());
        }
        stiffness.block<6, 6>(4 * e, 4 * e) += k;
        mass.block<6, 6>(4 * e, 4 * e) += m;
    }
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> solver(
        stiffness, mass, Eigen::EigenvaluesOnly | Eigen::Ax_lBx);
    constexpr Eigen::Index rigidMotions = 2;
    std::vector<double> frequencies;
    for (Eigen::Index i = rigidMotions; i < std::min<Eigen::Index>(rows, rigidMotions + count); ++i)
        frequencies.push_back(std::sqrt(std::max(solver.eigenvalues()(i), 0.0)) /
                              (2 * std::numbers::pi));
    return frequencies;
}

} // namespace idiophone
