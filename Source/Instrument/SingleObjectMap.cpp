#include "Instrument/SingleObjectMap.h"

#include "Instrument/ObjectBox.h"
#include "Instrument/StrikeStrip.h"
#include "Mesh/ObjectMesh.h"
#include "Mesh/SurfaceQuery.h"
#include "Mesh/SurfaceRoute.h"
#include "Synth/PlaceBetween.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

namespace idiophone {
namespace {

using Point = std::array<double, 3>;

constexpr int lowestKey = 36, highestKey = 96;

/// Returns how far the lowest modes move at a place under a push into the surface, as a sum over
/// modes.
double motionAt(const ModalObject& object, const StrikePoint& place) {
    constexpr std::size_t modes = 12;
    double sum = 0;
    for (std::size_t mode = 0; mode < std::min(modes, object.modeCount()); ++mode) {
        double along = 0;
        for (std::size_t corner = 0; corner < place.shapeRows.size(); ++corner) {
            if (place.weights[corner] == 0)
                continue;
            const auto shapes = object.shapesAt(static_cast<std::size_t>(place.shapeRows[corner]));
            for (std::size_t axis = 0; axis < 3; ++axis)
                along += static_cast<double>(place.weights[corner] * shapes[3 * mode + axis] *
                                             place.normal[axis]);
        }
        sum += std::abs(along);
    }
    return sum;
}

/// Leaves out the very ends, where a mallet slips off.
double liveliestPlace(const ModalObject& object, const KeyMap& map) {
    const auto strip = strikeStrip(object, map);
    double best = 0.5, most = -1;
    for (double along = 0.1; along < 0.9; along += 0.02)
        if (const double motion = motionAt(object, strip.at(along, 0)); motion > most) {
            most = motion;
            best = along;
        }
    return best;
}

Eigen::Vector3d vectorOf(const Point& point) {
    return Eigen::Vector3d(point.data());
}

/// Joins the hits to a path in metres. If rays missed between two hits, leads the path around the
/// hole.
std::vector<Eigen::Vector3d> roundHoles(const std::vector<std::optional<Eigen::Vector3d>>& hits,
                                        const Mesh& mesh,
                                        const Eigen::Vector3d& facing) {
    constexpr std::size_t maximumPlaces = 32;
    std::vector<Eigen::Vector3d> path;
    bool missed = false;
    for (const auto& hit : hits) {
        if (!hit) {
            missed = !path.empty();
            continue;
        }
        if (std::exchange(missed, false)) {
            const auto route = surfaceRoute(mesh, path.back(), *hit, facing);
            const std::size_t places = std::min(route.size(), maximumPlaces);
            for (std::size_t i = 1; i + 1 < places; ++i)
                path.push_back(route[i * (route.size() - 1) / (places - 1)]);
        }
        path.push_back(*hit);
    }
    return path;
}

} // namespace

KeyMap singleObjectMap(const ModalObject& object, const std::string& name, KeyMapKind kind) {
    KeyMap map{.kind = kind,
               .lowestNote = lowestKey,
               .highestNote = highestKey,
               .object = name,
               .strikePath = pathOverTop(object),
               .strikeAt = {0.5},
               .strikeWidth = 1,
               .referenceNote = -1};
    map.strikeAt.front() = liveliestPlace(object, map);
    return map;
}

std::vector<Point> pathOverTop(const ModalObject& object) {
    constexpr int samples = 33;
    constexpr double ends = 0.98; // fraction of the box, so that the outermost rays still hit
    const ObjectBox box(object);
    const auto along = box.longestAxis();
    const bool upright = along == 2;
    // Rays come from above, or from the player's side.
    const std::size_t depth = upright ? 1 : 2;
    const double side = upright ? -1 : 1;
    Point direction{};
    direction[depth] = -side;
    const SurfaceQuery surface(objectMesh(object));
    std::vector<std::optional<Eigen::Vector3d>> hits;
    for (int i = 0; i < samples; ++i) {
        Point from{};
        from[along] = ends * (2.0 * i / (samples - 1) - 1);
        from[depth] = side;
        Point origin = box.at(from);
        origin[depth] += side * box.halfExtentMetres[along];
        const auto hit = surface.firstHit(vectorOf(origin), vectorOf(direction));
        hits.push_back(hit ? std::optional(hit->pointMetres) : std::nullopt);
    }
    std::vector<Point> path;
    for (const auto& place : roundHoles(hits, surface.mesh(), -vectorOf(direction)))
        path.push_back(box.relative({place.x(), place.y(), place.z()}));
    if (path.size() < 2) {
        Point start{}, end{};
        start[along] = -1;
        end[along] = 1;
        start[depth] = end[depth] = side;
        path = {start, end};
    }
    return path;
}

std::vector<Point> pathMetres(const ModalObject& object, const KeyMap& map) {
    const ObjectBox box(object);
    std::vector<Point> path;
    for (const auto& relative : map.strikePath)
        path.push_back(box.at(relative));
    return path;
}

std::vector<Point> relativePath(const ModalObject& object, const std::vector<Point>& pathMetres) {
    const ObjectBox box(object);
    std::vector<Point> finite;
    for (const auto& point : pathMetres)
        if (std::ranges::all_of(point, [](double x) { return std::isfinite(x); }))
            finite.push_back(box.relative(point));
    if (finite.size() <= maximumPathPoints)
        return finite;
    std::vector<Point> path;
    for (std::size_t i = 0; i < maximumPathPoints; ++i)
        path.push_back(finite[i * (finite.size() - 1) / (maximumPathPoints - 1)]);
    return path;
}

} // namespace idiophone
