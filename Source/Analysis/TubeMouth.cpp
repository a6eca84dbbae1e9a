#include "Analysis/TubeMouth.h"

#include <cmath>
#include <complex>
#include <numbers>

namespace idiophone {

Eigen::Vector3d mouthMetres(const UndercutBar& shape, const Tube& tube) {
    return {tube.offsetMetres, 0, -shape.heightMetres - tube.gapMetres};
}

std::vector<Eigen::Vector3d> mouthPoints(const Eigen::Vector3d& centre, double radiusMetres) {
    std::vector<Eigen::Vector3d> points{centre};
    for (int k = 0; k < 6; ++k) {
        const double angle = k * std::numbers::pi / 3, radius = radiusMetres * std::sqrt(2.0 / 3);
        points.emplace_back(centre + radius * Eigen::Vector3d(std::cos(angle), std::sin(angle), 0));
    }
    return points;
}

double blockedOverFree(const UndercutBar& shape, const Tube& tube) {
    const double underMiddleMetres =
        shape.heightMetres - heightMetresAt(shape, tube.offsetMetres) + tube.gapMetres;
    return 1.22 + 0.165 * tube.radiusMetres / underMiddleMetres;
}

std::vector<double> mouthKgPerM2(double blockedOverFree,
                                 const Eigen::MatrixXcd& pressures,
                                 const std::vector<double>& eigenvalues) {
    std::vector<double> result;
    for (Eigen::Index mode = 0; mode < pressures.cols(); ++mode) {
        const std::complex<double> mean =
            pressures(0, mode) / 4.0 + pressures.col(mode).tail(pressures.rows() - 1).sum() / 8.0;
        result.push_back(blockedOverFree * mean.imag() / std::sqrt(eigenvalues[mode]));
    }
    return result;
}

} // namespace idiophone
