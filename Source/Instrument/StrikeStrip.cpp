#include "Instrument/StrikeStrip.h"

#include "Instrument/ObjectBox.h"
#include "Synth/PlaceBetween.h"
#include "World/ObjectSurface.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace idiophone {
namespace {

using Eigen::Vector3d;

constexpr int stripAlong = 129;
// Number of places on either side of the path. With it, a step beside the path is a third of the
// distance between vertices with shapes.
constexpr int minimumBeside = 1, maximumBeside = 32;
constexpr double stepsBetweenVertices = 3;
// Share of the object's size; too small to be heard.
constexpr double hair = 1e-7;

double length(const Vector3d& a) {
    return std::hypot(a.x(), a.y(), a.z());
}

Vector3d vectorOf(const std::array<float, 3>& a) {
    return Eigen::Vector3f(a.data()).cast<double>();
}

struct PathPlace {
    Vector3d point;
    Vector3d direction; ///< unit, or zero where the path has no length
};

double pathLength(const std::vector<Vector3d>& path) {
    double total = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        total += length(path[i] - path[i - 1]);
    return total;
}

/// Returns the place at a fraction of the path's length.
PathPlace placeOnPath(const std::vector<Vector3d>& path, double fraction) {
    double left = fraction * pathLength(path);
    for (std::size_t i = 1; i < path.size(); ++i) {
        const Vector3d step = path[i] - path[i - 1];
        const double stepLength = length(step);
        if (stepLength > 0 && (left <= stepLength || i + 1 == path.size()))
            return {path[i - 1] + step * std::min(left / stepLength, 1.0), step * (1 / stepLength)};
        left -= stepLength;
    }
    return {path.back(), Vector3d::Zero()};
}

/// Scales to unit length; returns zero if it is too short to have a direction.
std::array<float, 3> normalised(const Vector3d& a) {
    const double norm = length(a);
    if (norm < 1e-6)
        return {};
    return {static_cast<float>(a.x() / norm), static_cast<float>(a.y() / norm),
            static_cast<float>(a.z() / norm)};
}

/// Returns the unit vector of the direction's part in the surface.
std::array<float, 3> tangent(const std::array<float, 3>& normal, const Vector3d& direction) {
    const auto unit = vectorOf(normal);
    const double rise =
        direction.x() * unit.x() + direction.y() * unit.y() + direction.z() * unit.z();
    return normalised(direction - unit * rise);
}

} // namespace

StrikeStrip strikeStrip(const ModalObject& object, const KeyMap& map) {
    const ObjectBox box(object);
    const ObjectSurface surface(object);
    std::vector<Vector3d> path;
    for (const auto& relative : map.strikePath)
        path.emplace_back(box.at(relative).data());
    // A path through the middle of a solid must not change sides by rounding.
    const Vector3d upwards(0, 0, hair * length(Vector3d(box.halfExtentMetres.data())));
    const auto pointAt = [&](const Vector3d& middle) {
        const Vector3d point = middle + upwards;
        return surface.nearest({point.x(), point.y(), point.z()});
    };

    struct Rung {
        PathPlace middle;
        Vector3d reach; ///< from the middle to the strip's edge
    };
    std::vector<Rung> rungs;
    double widest = 0;
    for (int along = 0; along < stripAlong; ++along) {
        const auto middle = placeOnPath(path, along / (stripAlong - 1.0));
        Vector3d reach = vectorOf(pointAt(middle.point).normal).cross(middle.direction);
        if (const double norm = length(reach); norm > 0) {
            const Vector3d unit = reach * (1 / norm);
            reach *= map.strikeWidth * box.reachMetres({unit.x(), unit.y(), unit.z()}) / norm;
        }
        widest = std::max(widest, length(reach));
        rungs.push_back({middle, reach});
    }

    const double steps =
        widest > 0 ? std::ceil(stepsBetweenVertices * widest / surface.meanEdgeMetres()) : 0;
    const int beside = static_cast<int>(std::clamp<double>(steps, minimumBeside, maximumBeside));
    StrikeStrip strip;
    strip.alongCount = stripAlong;
    strip.acrossCount = 2 * beside + 1;
    strip.lengthMetres = pathLength(path);
    for (const auto& [middle, reach] : rungs)
        for (int across = -beside; across <= beside; ++across) {
            strip.points.push_back(pointAt(middle.point + reach * (double(across) / beside)));
            strip.directions.push_back(tangent(strip.points.back().normal, middle.direction));
        }
    return strip;
}

std::size_t StrikeStrip::index(int alongIndex, int acrossIndex) const {
    return static_cast<std::size_t>(alongIndex) * static_cast<std::size_t>(acrossCount) +
           static_cast<std::size_t>(acrossIndex);
}

const StrikePoint& StrikeStrip::at(double along, double across) const {
    const auto nearest = [](double share, int count) {
        return static_cast<int>(std::lround(std::clamp(share, 0.0, 1.0) * (count - 1)));
    };
    return points[index(nearest(along, alongCount), nearest((across + 1) / 2, acrossCount))];
}

// Each square of four places is cut into two triangles, along the diagonal from (0, 0) to (1, 1).
StripPlace StrikeStrip::between(double along, double across) const {
    const double x = std::clamp(along, 0.0, 1.0) * (alongCount - 1);
    const double y = std::clamp((across + 1) / 2, 0.0, 1.0) * (acrossCount - 1);
    const int i = std::min(static_cast<int>(x), alongCount - 2);
    const int j = std::min(static_cast<int>(y), acrossCount - 2);
    const double u = x - i, v = y - j;
    const bool below = u >= v;
    const std::array corners{index(i, j), below ? index(i + 1, j) : index(i, j + 1),
                             index(i + 1, j + 1)};
    const std::array weights{1 - std::max(u, v), std::abs(u - v), std::min(u, v)};

    PlaceBetween point;
    std::array<float, 3> direction{};
    for (std::size_t k = 0; k < corners.size(); ++k) {
        point.add(points[corners[k]], weights[k]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            direction[axis] += static_cast<float>(weights[k]) * directions[corners[k]][axis];
    }
    const auto heaviest =
        static_cast<std::size_t>(std::ranges::max_element(weights) - weights.begin());
    const auto mean = normalised(vectorOf(direction));
    return {.point = point.point(),
            .direction = mean == std::array<float, 3>{} ? directions[corners[heaviest]] : mean};
}

StripStep StrikeStrip::around(double along, double across) const {
    const double steps = alongCount - 1;
    const double x = std::clamp(along, 0.0, 1.0) * steps;
    const double first = std::min(std::floor(x), steps - 1);
    return {.first = between(first / steps, across),
            .second = between((first + 1) / steps, across),
            .fraction = x - first};
}

} // namespace idiophone
