#include "Analysis/PanelPotentials.h"

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

/// Returns ∫ n·R/r³ dS.
double signedSolidAngle(const Eigen::Matrix3d& corners, const std::array<double, 3>& distances) {
    const auto a = corners.col(0), b = corners.col(1), c = corners.col(2);
    const double volume = a.dot(b.cross(c));
    const double denominator = distances[0] * distances[1] * distances[2] +
                               a.dot(b) * distances[2] + b.dot(c) * distances[0] +
                               c.dot(a) * distances[1];
    return -2 * std::atan2(volume, denominator);
}

} // namespace

PanelPotentials panelPotentials(const Eigen::Matrix3d& corners,
                                const Eigen::Vector3d& normal,
                                const Eigen::Vector3d& point) {
    constexpr double flat = 1e-9; // of a distance; a nearer point counts as in the plane
    const Eigen::Matrix3d fromPoint = corners.colwise() - point;
    std::array<double, 3> distances{};
    for (int k = 0; k < 3; ++k)
        distances[k] = fromPoint.col(k).norm();
    const double height = -normal.dot(fromPoint.col(0));
    const bool isInPlane = std::abs(height) <= flat * (distances[0] + distances[1] + distances[2]);
    const double solidAngle = isInPlane ? 0 : signedSolidAngle(fromPoint, distances);

    double single = -height * solidAngle;
    Eigen::Vector3d singleGradient = -solidAngle * normal;
    Eigen::Vector3d doubleGradient = Eigen::Vector3d::Zero();
    for (int k = 0; k < 3; ++k) {
        const int next = (k + 1) % 3;
        const auto a = fromPoint.col(k), b = fromPoint.col(next);
        const double ra = distances[k], rb = distances[next];
        const Eigen::Vector3d edge = b - a;
        const double length = edge.norm();
        const Eigen::Vector3d outward = edge.cross(normal) / length;
        const double logarithm = std::log((ra + rb + length) / (ra + rb - length));
        single += outward.dot(a) * logarithm;
        singleGradient -= outward * logarithm;
        doubleGradient -= a.cross(b) * ((ra + rb) / (ra * rb * (ra * rb + a.dot(b))));
    }
    constexpr double share = 1 / (4 * std::numbers::pi);
    return {share * single, share * solidAngle, share * singleGradient, share * doubleGradient};
}

} // namespace idiophone
