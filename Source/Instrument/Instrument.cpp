#include "Instrument/Instrument.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace idiophone {
namespace {

using Point = std::array<double, 3>;

// Finer than the vertices of the factory objects, so that the table loses nothing.
constexpr int stripAlong = 129;
constexpr int stripAcross = 17;

Point operator+(const Point& a, const Point& b) {
    return {a[0] + b[0], a[1] + b[1], a[2] + b[2]};
}
Point operator-(const Point& a, const Point& b) {
    return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}
Point operator*(const Point& a, double factor) {
    return {a[0] * factor, a[1] * factor, a[2] * factor};
}
Point cross(const Point& a, const Point& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}
double length(const Point& a) {
    return std::hypot(a[0], a[1], a[2]);
}

struct BoundingBox {
    Point centre{};
    Point halfExtent{};

    explicit BoundingBox(const ModalObject& object) {
        for (std::size_t axis = 0; axis < 3; ++axis) {
            double lowest = std::numeric_limits<double>::infinity();
            double highest = -lowest;
            for (std::size_t i = axis; i < object.vertices.size(); i += 3) {
                lowest = std::min(lowest, static_cast<double>(object.vertices[i]));
                highest = std::max(highest, static_cast<double>(object.vertices[i]));
            }
            centre[axis] = (lowest + highest) / 2;
            halfExtent[axis] = (highest - lowest) / 2;
        }
    }

    Point at(const Point& relative) const {
        return {centre[0] + relative[0] * halfExtent[0], centre[1] + relative[1] * halfExtent[1],
                centre[2] + relative[2] * halfExtent[2]};
    }

    double reach(const Point& direction) const {
        return std::abs(direction[0]) * halfExtent[0] + std::abs(direction[1]) * halfExtent[1] +
               std::abs(direction[2]) * halfExtent[2];
    }
};

struct PathPlace {
    Point point;
    Point direction; ///< unit, or zero where the path has no length
};

double pathLength(const std::vector<Point>& path) {
    double total = 0;
    for (std::size_t i = 1; i < path.size(); ++i)
        total += length(path[i] - path[i - 1]);
    return total;
}

/// The place at a fraction of the path's length.
PathPlace placeOnPath(const std::vector<Point>& path, double fraction) {
    double left = fraction * pathLength(path);
    for (std::size_t i = 1; i < path.size(); ++i) {
        const auto step = path[i] - path[i - 1];
        const double stepLength = length(step);
        if (stepLength > 0 && (left <= stepLength || i + 1 == path.size()))
            return {path[i - 1] + step * std::min(left / stepLength, 1.0), step * (1 / stepLength)};
        left -= stepLength;
    }
    return {path.back(), {}};
}

using Vector = std::array<float, 3>;

/// To unit length; zero where it is too short to have a direction.
Vector normalised(const Point& a) {
    const double norm = length(a);
    if (norm < 1e-6)
        return {};
    return {static_cast<float>(a[0] / norm), static_cast<float>(a[1] / norm),
            static_cast<float>(a[2] / norm)};
}

/// What of a direction lies in the surface.
Vector tangent(const Vector& normal, const Point& direction) {
    const Point unit{normal[0], normal[1], normal[2]};
    const double rise = direction[0] * unit[0] + direction[1] * unit[1] + direction[2] * unit[2];
    return normalised(direction - unit * rise);
}

/// Of unit length between two unit vectors; the first where they point apart.
Vector between(const Vector& a, const Vector& b, double way) {
    const Point first{a[0], a[1], a[2]}, second{b[0], b[1], b[2]};
    const auto mean = normalised(first * (1 - way) + second * way);
    return mean == Vector{} ? a : mean;
}

StrikeStrip buildStrip(const ModalObject& object, const KeyMap& map) {
    const BoundingBox box(object);
    std::vector<Point> path;
    for (const auto& relative : map.strikePath)
        path.push_back(box.at(relative));
    const auto normals = vertexNormals(object);
    const auto pointAt = [&](std::size_t row) {
        const auto* normal = &normals[static_cast<std::size_t>(object.shapeVertices[row]) * 3];
        return StrikePoint{.shapeRows = {static_cast<std::int32_t>(row), 0, 0},
                           .weights = {1, 0, 0},
                           .normal = {normal[0], normal[1], normal[2]}};
    };

    StrikeStrip strip;
    strip.alongCount = stripAlong;
    strip.acrossCount = stripAcross;
    strip.lengthMetres = pathLength(path);
    for (int along = 0; along < stripAlong; ++along) {
        const auto place = placeOnPath(path, along / (stripAlong - 1.0));
        const auto middle = pointAt(nearestShapeRow(object, place.point));
        const Point normal{middle.normal[0], middle.normal[1], middle.normal[2]};
        Point sideways = cross(normal, place.direction);
        if (const double norm = length(sideways); norm > 0)
            sideways = sideways * (map.strikeWidth * box.reach(sideways * (1 / norm)) / norm);
        for (int across = 0; across < stripAcross; ++across) {
            const double offset = 2 * across / (stripAcross - 1.0) - 1;
            strip.points.push_back(
                pointAt(nearestShapeRow(object, place.point + sideways * offset)));
            strip.directions.push_back(tangent(strip.points.back().normal, place.direction));
        }
    }
    return strip;
}

double midiNoteHz(double note) {
    return 440 * std::exp2((note - 69) / 12);
}

/// The damped frequency of the lowest mode.
double lowestModeHz(const ModalObject& object) {
    const double eigenvalue = object.eigenvalues.front();
    const double decay = (object.material.fluidDampingPerSecond +
                          object.material.viscoelasticDampingSeconds * eigenvalue) /
                         2;
    return std::sqrt(std::max(eigenvalue - decay * decay, 1.0)) / (2 * std::numbers::pi);
}

} // namespace

std::size_t StrikeStrip::index(int alongIndex, double across) const {
    const double place = std::clamp((across + 1) / 2, 0.0, 1.0) * (acrossCount - 1);
    return static_cast<std::size_t>(alongIndex) * static_cast<std::size_t>(acrossCount) +
           static_cast<std::size_t>(std::lround(place));
}

const StrikePoint& StrikeStrip::at(double along, double across) const {
    const double place = std::clamp(along, 0.0, 1.0) * (alongCount - 1);
    return points[index(static_cast<int>(std::lround(place)), across)];
}

StripPlace StrikeStrip::between(double along, double across) const {
    const double place = std::clamp(along, 0.0, 1.0) * (alongCount - 1);
    const int before = std::min(static_cast<int>(place), alongCount - 2);
    const double way = place - before;
    const auto first = index(before, across), second = index(before + 1, across);
    StripPlace result{.point = points[first],
                      .direction = idiophone::between(directions[first], directions[second], way)};
    if (points[second].shapeRows == points[first].shapeRows)
        return result;
    result.point.shapeRows[1] = points[second].shapeRows[0];
    result.point.weights = {static_cast<float>(1 - way), static_cast<float>(way), 0};
    result.point.normal = idiophone::between(points[first].normal, points[second].normal, way);
    return result;
}

Result<std::shared_ptr<const Instrument>> Instrument::build(const KeyMap& keyMap,
                                                            ObjectLibrary& library) {
    if (keyMap.lowestNote < 0 || keyMap.highestNote > 127 ||
        keyMap.lowestNote > keyMap.highestNote || keyMap.strikePath.empty())
        return failure("the key map's notes are not between 0 and 127, or it has no strike path");
    auto instrument = std::shared_ptr<Instrument>(new Instrument(keyMap));
    const auto built = keyMap.kind == KeyMapKind::bars ? instrument->buildBars(library)
                                                       : instrument->buildSingleObject(library);
    if (!built)
        return tl::unexpected(built.error());
    return instrument;
}

Result<void> Instrument::buildBars(ObjectLibrary& library) {
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        auto object = library.find(map.objectFor(note));
        if (!object)
            return tl::unexpected(object.error());
        keys[static_cast<std::size_t>(note)] = {.slot = static_cast<int>(synthesiserSlots.size()),
                                                .strip = static_cast<int>(strips.size()),
                                                .along = map.strikeAt,
                                                .malletScale = 1};
        strips.push_back(buildStrip(**object, map));
        synthesiserSlots.push_back({.object = std::move(*object), .sizeRatio = 1});
    }
    return {};
}

Result<void> Instrument::buildSingleObject(ObjectLibrary& library) {
    auto object = library.find(map.object);
    if (!object)
        return tl::unexpected(object.error());
    strips.push_back(buildStrip(**object, map));

    const double referenceHz =
        map.referenceNote >= 0 ? midiNoteHz(map.referenceNote) : lowestModeHz(**object);
    const int range = map.highestNote - map.lowestNote;
    for (int note = map.lowestNote; note <= map.highestNote; ++note) {
        auto& key = keys[static_cast<std::size_t>(note)];
        if (map.kind == KeyMapKind::zones) {
            key = {.slot = 0,
                   .strip = 0,
                   .along = range > 0 ? static_cast<double>(note - map.lowestNote) / range
                                      : map.strikeAt,
                   .malletScale = 1};
            continue;
        }
        // The mallet is scaled with the object: every key is the same event at another size, where
        // one mallet for all would make small objects louder by the cube of their pitch.
        const double sizeRatio = referenceHz / midiNoteHz(note);
        key = {.slot = static_cast<int>(synthesiserSlots.size()),
               .strip = 0,
               .along = map.strikeAt,
               .malletScale = sizeRatio};
        synthesiserSlots.push_back({.object = *object, .sizeRatio = sizeRatio});
    }
    if (map.kind == KeyMapKind::zones)
        synthesiserSlots.push_back({.object = *object, .sizeRatio = 1});
    return {};
}

} // namespace idiophone
