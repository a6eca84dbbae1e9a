#include "Geometry/LatheMesh.h"

#include "Geometry/MeshBuilder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double pi = std::numbers::pi;
constexpr double cornerCosine = 0.866; // cos 30°

Eigen::Vector2d placeOf(const LathePoint& point) {
    return {point.radiusMetres, point.heightMetres};
}

LathePoint between(const LathePoint& a, const LathePoint& b, double share) {
    return {std::lerp(a.radiusMetres, b.radiusMetres, share),
            std::lerp(a.heightMetres, b.heightMetres, share),
            std::lerp(a.thicknessMetres, b.thicknessMetres, share)};
}

bool isCorner(const std::vector<LathePoint>& section, std::size_t i) {
    const Eigen::Vector2d before = placeOf(section[i]) - placeOf(section[i - 1]);
    const Eigen::Vector2d after = placeOf(section[i + 1]) - placeOf(section[i]);
    return before.dot(after) < cornerCosine * before.norm() * after.norm();
}

/// Appends points along section[first … last] in even steps of about `step`, without the first one.
void appendEvenly(const std::vector<LathePoint>& section,
                  std::size_t first,
                  std::size_t last,
                  double step,
                  std::vector<LathePoint>& rows) {
    std::vector<double> lengths{0};
    for (std::size_t i = first; i < last; ++i)
        lengths.push_back(lengths.back() + (placeOf(section[i + 1]) - placeOf(section[i])).norm());
    const int steps = std::max(1, static_cast<int>(std::lround(lengths.back() / step)));
    std::size_t segment = 0;
    for (int k = 1; k < steps; ++k) {
        const double at = lengths.back() * k / steps;
        while (lengths[segment + 1] < at)
            ++segment;
        rows.push_back(
            between(section[first + segment], section[first + segment + 1],
                    (at - lengths[segment]) / (lengths[segment + 1] - lengths[segment])));
    }
    rows.push_back(section[last]);
}

std::vector<LathePoint> evenRows(const std::vector<LathePoint>& section, double step) {
    std::vector<LathePoint> rows{section.front()};
    std::size_t first = 0;
    for (std::size_t i = 1; i < section.size(); ++i)
        if (i + 1 == section.size() || isCorner(section, i)) {
            appendEvenly(section, first, i, step, rows);
            first = i;
        }
    return rows;
}

/// Returns the number of vertices on the circle: 1 at a pole, else 6, 12 or a multiple of 24.
int countAround(double radiusMetres, double edgeMetres) {
    const double wanted = 2 * pi * radiusMetres / edgeMetres;
    if (radiusMetres == 0)
        return 1;
    if (wanted < 18)
        return wanted < 9 ? 6 : 12;
    return 24 * std::max(1, static_cast<int>(std::lround(wanted / 24)));
}

struct Circle {
    int firstVertex = 0;
    int count = 1;
    double turn = 0; ///< angle of vertex 0 in radians

    double angle(int k) const { return turn + 2 * pi * k / count; }
    int vertex(int k) const { return firstVertex + k % count; }
};

/// Fills the band between two circles. Walks both circles and advances on the one whose next
/// segment lies further back.
void stitch(const Circle& lower, const Circle& upper, MeshBuilder& mesh) {
    const int lowerSteps = lower.count > 1 ? lower.count : 0;
    const int upperSteps = upper.count > 1 ? upper.count : 0;
    constexpr double tie = 1e-9; // with 0, rounding would decide and sectors would differ
    int i = 0, j = 0;
    while (i < lowerSteps || j < upperSteps) {
        const bool advanceLower =
            j == upperSteps || (i < lowerSteps && lower.angle(i) + lower.angle(i + 1) <
                                                      upper.angle(j) + upper.angle(j + 1) + tie);
        if (advanceLower) {
            mesh.face(lower.vertex(i), lower.vertex(i + 1), upper.vertex(j));
            ++i;
        } else {
            mesh.face(lower.vertex(i), upper.vertex(j + 1), upper.vertex(j));
            ++j;
        }
    }
}

} // namespace

LatheMesh latheMesh(const std::vector<LathePoint>& section, double edgeMetres) {
    const auto rows = evenRows(section, edgeMetres * std::sqrt(3.0) / 2);
    std::vector<Circle> circles;
    std::vector<double> thicknesses;
    MeshBuilder mesh;
    for (const auto& row : rows) {
        Circle circle{.firstVertex = static_cast<int>(mesh.vertices.size()),
                      .count = countAround(row.radiusMetres, edgeMetres)};
        if (!circles.empty() && circles.back().count == circle.count && circles.back().turn == 0)
            circle.turn = pi / circle.count;
        for (int k = 0; k < circle.count; ++k)
            mesh.add(row.radiusMetres * std::cos(circle.angle(k)),
                     row.radiusMetres * std::sin(circle.angle(k)), row.heightMetres);
        thicknesses.resize(mesh.vertices.size(), row.thicknessMetres);
        if (!circles.empty())
            stitch(circles.back(), circle, mesh);
        circles.push_back(circle);
    }
    return {mesh.mesh(), Eigen::Map<const Eigen::VectorXd>(thicknesses.data(), thicknesses.size())};
}

} // namespace idiophone
