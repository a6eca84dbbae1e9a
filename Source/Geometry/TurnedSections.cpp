#include "Geometry/TurnedSections.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr int steps = 40; // per curve: finer than any mesh of a curve
constexpr double quarterTurn = std::numbers::pi / 2;

/// Chosen together with the factory handbell's measures, so that its (3,0) mode lies a twelfth
/// above (2,0).
constexpr double flareExponent = 2;
constexpr double lipShare = 0.25; // fraction of the height

Eigen::Vector3d figuresOf(const LathePoint& point) {
    return {point.radiusMetres, point.heightMetres, point.thicknessMetres};
}

/// Appends a cubic curve through points without a corner between them, without the first point. The
/// slope at a point is that of the parabola through it and its neighbours.
void appendCurve(std::span<const LathePoint> points, std::vector<LathePoint>& section) {
    constexpr int stepsBetween = 12;
    const std::size_t spans = points.size() - 1;
    std::vector<double> lengths;
    std::vector<Eigen::Vector3d> slopes;
    for (std::size_t i = 0; i < spans; ++i) {
        const Eigen::Vector3d step = figuresOf(points[i + 1]) - figuresOf(points[i]);
        lengths.push_back(step.head<2>().norm());
        slopes.push_back(step / lengths.back());
    }
    const auto slopeAt = [&](std::size_t i) -> Eigen::Vector3d {
        if (i == 0 || i == spans)
            return slopes[i == 0 ? 0 : spans - 1];
        const double before = lengths[i - 1], after = lengths[i];
        return (slopes[i - 1] * after + slopes[i] * before) / (before + after);
    };
    for (std::size_t i = 0; i < spans; ++i)
        for (int step = 1; step <= stepsBetween; ++step) {
            const double u = static_cast<double>(step) / stepsBetween, v = 1 - u;
            const Eigen::Vector3d at = v * v * (1 + 2 * u) * figuresOf(points[i]) +
                                       u * u * (1 + 2 * v) * figuresOf(points[i + 1]) +
                                       u * v * lengths[i] * (v * slopeAt(i) - u * slopeAt(i + 1));
            section.push_back({std::max(0.0, at.x()), at.y(), at.z()});
        }
}

} // namespace

std::vector<LathePoint> bellSection(const BellMeasures& bell) {
    std::vector<LathePoint> section;
    const double sideHeight = bell.heightMetres - bell.shoulderCurveMetres;
    for (int k = 0; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps;
        const double flare = std::pow(1 - share, flareExponent);
        const double inLip = std::max(0.0, 1 - share * sideHeight / (lipShare * bell.heightMetres));
        section.push_back(
            {.radiusMetres = std::lerp(bell.shoulderRadiusMetres, bell.lipRadiusMetres, flare),
             .heightMetres = share * sideHeight,
             .thicknessMetres =
                 std::lerp(bell.sideThicknessMetres, bell.lipThicknessMetres, inLip)});
    }
    for (int k = 1; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps, angle = share * quarterTurn;
        section.push_back({.radiusMetres = bell.shoulderRadiusMetres -
                                           bell.shoulderCurveMetres * (1 - std::cos(angle)),
                           .heightMetres = sideHeight + bell.shoulderCurveMetres * std::sin(angle),
                           .thicknessMetres = std::lerp(bell.sideThicknessMetres,
                                                        bell.crownThicknessMetres, share)});
    }
    section.push_back({.radiusMetres = 0,
                       .heightMetres = bell.heightMetres,
                       .thicknessMetres = bell.crownThicknessMetres});
    return section;
}

std::vector<LathePoint> bowlSection(const BowlMeasures& bowl) {
    std::vector<LathePoint> section{{0, 0, bowl.footThicknessMetres}};
    for (int k = 0; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps, angle = share * quarterTurn;
        section.push_back({.radiusMetres = std::lerp(bowl.footRadiusMetres, bowl.rimRadiusMetres,
                                                     std::sin(angle)),
                           .heightMetres = bowl.heightMetres * (1 - std::cos(angle)),
                           .thicknessMetres = std::lerp(bowl.footThicknessMetres,
                                                        bowl.rimThicknessMetres, share)});
    }
    return section;
}

std::vector<LathePoint>
capSection(double rimRadiusMetres, double depthMetres, double thicknessMetres) {
    const double sphere =
        (rimRadiusMetres * rimRadiusMetres + depthMetres * depthMetres) / (2 * depthMetres);
    const double opening = std::atan2(rimRadiusMetres, sphere - depthMetres);
    std::vector<LathePoint> section;
    for (int k = 0; k <= steps; ++k) {
        const double angle = opening * k / steps;
        section.push_back(
            {sphere * std::sin(angle), sphere * (1 - std::cos(angle)), thicknessMetres});
    }
    return section;
}

std::vector<LathePoint> caseSection(const CaseMeasures& measures) {
    const double corner = measures.cornerMetres;
    std::vector<LathePoint> section{{0, 0, measures.baseThicknessMetres}};
    for (int k = 0; k <= steps; ++k) {
        const double share = static_cast<double>(k) / steps, angle = share * quarterTurn;
        section.push_back(
            {.radiusMetres = measures.baseRadiusMetres - corner * (1 - std::sin(angle)),
             .heightMetres = corner * (1 - std::cos(angle)),
             .thicknessMetres =
                 std::lerp(measures.baseThicknessMetres, measures.wallThicknessMetres, share)});
    }
    const double wall = measures.heightMetres - corner;
    const double taper = wall - measures.mouthHeightMetres;
    for (const double height : {taper, wall})
        section.push_back(
            {.radiusMetres = measures.mouthRadiusMetres,
             .heightMetres = corner + height,
             .thicknessMetres = std::lerp(measures.wallThicknessMetres,
                                          measures.mouthThicknessMetres, height / wall)});
    return section;
}

std::vector<LathePoint> smoothSection(std::span<const LathePoint> points) {
    std::vector<LathePoint> section{points.front()};
    std::size_t first = 0;
    for (std::size_t i = 1; i <= points.size(); ++i)
        if (i == points.size() || points[i] == points[i - 1]) {
            if (i - first > 1)
                appendCurve(points.subspan(first, i - first), section);
            first = i;
        }
    return section;
}

} // namespace idiophone
