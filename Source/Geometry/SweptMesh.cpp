#include "Geometry/SweptMesh.h"

#include "Geometry/MeshBuilder.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

using Eigen::Vector3d;

/// Appends evenly spaced points after the last one, up to `end`.
void appendLine(const Vector3d& end, double stepMetres, std::vector<Vector3d>& path) {
    const Vector3d start = path.back();
    const int steps = std::max(1, static_cast<int>(std::ceil((end - start).norm() / stepMetres)));
    for (int k = 1; k <= steps; ++k)
        path.emplace_back(start + (end - start) * k / steps);
}

Eigen::RowVector3d place(const Vector3d& point) {
    return point.transpose();
}

} // namespace

Mesh rodMesh(const std::vector<Vector3d>& pathMetres, double radiusMetres, int sides) {
    const auto last = static_cast<int>(pathMetres.size()) - 1;
    const auto directionAt = [&](int i) -> Vector3d {
        return (pathMetres[std::min(i + 1, last)] - pathMetres[std::max(i - 1, 0)]).normalized();
    };
    MeshBuilder builder;
    Vector3d along = directionAt(0), across = along.unitOrthogonal();
    for (int i = 0; i <= last; ++i) {
        const Vector3d next = directionAt(i);
        across = Eigen::Quaterniond::FromTwoVectors(along, next) * across;
        along = next;
        const Vector3d up = along.cross(across);
        for (int k = 0; k < sides; ++k) {
            const double angle = 2 * std::numbers::pi * k / sides;
            builder.add(place(pathMetres[i] +
                              radiusMetres * (std::cos(angle) * across + std::sin(angle) * up)));
        }
    }
    const int start = builder.add(place(pathMetres.front())),
              end = builder.add(place(pathMetres.back()));
    for (int k = 0; k < sides; ++k) {
        const int next = (k + 1) % sides, top = last * sides;
        builder.face(start, next, k);
        builder.face(end, top + k, top + next);
        for (int i = 0; i < last; ++i) {
            const int low = i * sides, high = low + sides;
            builder.face(low + k, low + next, high + next);
            builder.face(low + k, high + next, high + k);
        }
    }
    return builder.mesh();
}

std::vector<Vector3d> roundedPath(const std::vector<Vector3d>& cornersMetres,
                                  double bendRadiusMetres,
                                  double stepMetres) {
    std::vector<Vector3d> path{cornersMetres.front()};
    for (std::size_t i = 1; i + 1 < cornersMetres.size(); ++i) {
        const Vector3d in = (cornersMetres[i] - cornersMetres[i - 1]).normalized();
        const Vector3d out = (cornersMetres[i + 1] - cornersMetres[i]).normalized();
        const double turn = std::acos(in.dot(out));
        const double cut = bendRadiusMetres * std::tan(turn / 2);
        const Vector3d begin = cornersMetres[i] - cut * in;
        appendLine(begin, stepMetres, path);
        const Vector3d inward = (out - in.dot(out) * in).normalized();
        const int steps =
            std::max(1, static_cast<int>(std::ceil(bendRadiusMetres * turn / stepMetres)));
        for (int k = 1; k <= steps; ++k) {
            const double angle = turn * k / steps;
            path.emplace_back(begin + bendRadiusMetres *
                                          (std::sin(angle) * in + (1 - std::cos(angle)) * inward));
        }
    }
    appendLine(cornersMetres.back(), stepMetres, path);
    return path;
}

} // namespace idiophone
