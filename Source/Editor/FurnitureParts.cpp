#include "Editor/FurnitureParts.h"

#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

using Vector = Eigen::Vector3f;

/// Two axes across a direction; an upright direction gets x and y.
struct Across {
    explicit Across(const Vector& along)
        : first(std::abs(along.z()) > 0.99f ? Vector::UnitX()
                                            : Vector(along.cross(Vector::UnitZ()).normalized())),
          second(along.cross(first)) {}

    Vector around(int step, int sides) const {
        const float angle = 2 * std::numbers::pi_v<float> * float(step) / float(sides);
        return std::cos(angle) * first + std::sin(angle) * second;
    }

    Vector first, second;
};

} // namespace

void FurnitureParts::addFace(const Vector& a, const Vector& b, const Vector& c) {
    const Vector normal = (b - a).cross(c - a).normalized();
    for (const auto& place : {a, b, c})
        vertices.push_back({scenePlace(place), scenePlace(normal)});
}

void FurnitureParts::addQuad(const std::array<Vector, 4>& places,
                             const std::array<Vector, 4>& normals) {
    for (const std::size_t corner : {0u, 1u, 2u, 0u, 2u, 3u})
        vertices.push_back({scenePlace(places[corner]), scenePlace(normals[corner])});
}

void FurnitureParts::addBeam(
    const Vector& from, const Vector& to, float width, float height, const Vector& up) {
    const Vector along = (to - from).normalized();
    const Vector side = along.cross(up).normalized() * (width / 2);
    const Vector top = side.cross(along).normalized() * (height / 2);
    const auto corner = [&](int x, int y, int z) -> Vector {
        return (x == 0 ? from : to) + (y == 0 ? Vector(-side) : side) +
               (z == 0 ? Vector(-top) : top);
    };
    const auto addSide = [&](const Vector& a, const Vector& b, const Vector& c, const Vector& d) {
        addFace(a, b, c);
        addFace(a, c, d);
    };
    addSide(corner(0, 0, 1), corner(0, 1, 1), corner(1, 1, 1), corner(1, 0, 1));
    addSide(corner(0, 1, 0), corner(0, 0, 0), corner(1, 0, 0), corner(1, 1, 0));
    addSide(corner(0, 1, 1), corner(0, 1, 0), corner(1, 1, 0), corner(1, 1, 1));
    addSide(corner(0, 0, 0), corner(0, 0, 1), corner(1, 0, 1), corner(1, 0, 0));
    addSide(corner(0, 0, 0), corner(0, 1, 0), corner(0, 1, 1), corner(0, 0, 1));
    addSide(corner(1, 1, 0), corner(1, 0, 0), corner(1, 0, 1), corner(1, 1, 1));
}

void FurnitureParts::addWall(const Vector& from,
                             const Vector& to,
                             float fromRadius,
                             float toRadius,
                             int sides,
                             bool inward) {
    const Across across((to - from).normalized());
    for (int step = 0; step < sides; ++step) {
        const Vector left = across.around(step, sides), right = across.around(step + 1, sides);
        const std::array<Vector, 4> places{from + fromRadius * left, from + fromRadius * right,
                                           to + toRadius * right, to + toRadius * left};
        if (inward)
            addQuad({places[3], places[2], places[1], places[0]},
                    {Vector(-left), Vector(-right), Vector(-right), Vector(-left)});
        else
            addQuad(places, {left, right, right, left});
    }
}

void FurnitureParts::addCap(const Vector& middle, const Vector& normal, float radius, int sides) {
    const Across across(normal);
    for (int step = 0; step < sides; ++step)
        addFace(middle, middle + radius * across.around(step, sides),
                middle + radius * across.around(step + 1, sides));
}

void FurnitureParts::addRod(
    const Vector& from, const Vector& to, float fromRadius, float toRadius, int sides) {
    const Vector along = (to - from).normalized();
    addWall(from, to, fromRadius, toRadius, sides, false);
    addCap(from, -along, fromRadius, sides);
    addCap(to, along, toRadius, sides);
}

void FurnitureParts::addPipe(const Vector& top, float length, float radius, float wall, int sides) {
    const Vector bottom = top - length * Vector::UnitZ();
    const float inner = radius - wall;
    addWall(bottom, top, radius, radius, sides, false);
    addWall(bottom + wall * Vector::UnitZ(), top, inner, inner, sides, true);
    addCap(bottom, -Vector::UnitZ(), radius, sides);
    addCap(bottom + wall * Vector::UnitZ(), Vector::UnitZ(), inner, sides);
    const Across across(Vector::UnitZ());
    constexpr auto up = [] { return Vector(Vector::UnitZ()); };
    for (int step = 0; step < sides; ++step) {
        const Vector left = across.around(step, sides), right = across.around(step + 1, sides);
        addQuad(
            {top + inner * left, top + radius * left, top + radius * right, top + inner * right},
            {up(), up(), up(), up()});
    }
}

void FurnitureParts::addRing(const Vector& middle, float radius, float thickness, int sides) {
    constexpr int section = 10;
    const Across across(Vector::UnitZ());
    const auto normal = [&](int step, int turn) -> Vector {
        const float angle = 2 * std::numbers::pi_v<float> * float(turn) / float(section);
        return std::cos(angle) * across.around(step, sides) + std::sin(angle) * Vector::UnitZ();
    };
    for (int step = 0; step < sides; ++step)
        for (int turn = 0; turn < section; ++turn) {
            const std::array<Vector, 4> normals{normal(step, turn), normal(step + 1, turn),
                                                normal(step + 1, turn + 1), normal(step, turn + 1)};
            std::array<Vector, 4> places;
            for (std::size_t i = 0; i < places.size(); ++i)
                places[i] = middle +
                            radius * across.around(i == 1 || i == 2 ? step + 1 : step, sides) +
                            thickness / 2 * normals[i];
            addQuad(places, normals);
        }
}

void FurnitureParts::addDisc(
    const Vector& middle, const Vector& normal, float radius, float thickness, int sides) {
    const Vector half = thickness / 2 * normal;
    addRod(middle - half, middle + half, radius, radius, sides);
}

void FurnitureParts::addBall(const Vector& middle, float radius, int sides) {
    const Across across(Vector::UnitZ());
    const int rings = sides / 2;
    const auto normal = [&](int step, int ring) -> Vector {
        const float angle = std::numbers::pi_v<float> * float(ring) / float(rings);
        return std::sin(angle) * across.around(step, sides) - std::cos(angle) * Vector::UnitZ();
    };
    for (int step = 0; step < sides; ++step)
        for (int ring = 0; ring < rings; ++ring) {
            const std::array<Vector, 4> normals{normal(step, ring), normal(step + 1, ring),
                                                normal(step + 1, ring + 1), normal(step, ring + 1)};
            std::array<Vector, 4> places;
            for (std::size_t i = 0; i < places.size(); ++i)
                places[i] = middle + radius * normals[i];
            addQuad(places, normals);
        }
}

FurniturePart& FurnitureParts::finish(const Appearance& look, Form form) {
    Eigen::AlignedBox3f box;
    for (std::size_t i = begin - base; i < vertices.size(); ++i)
        box.extend(vectorOf(vertices[i].place));
    const auto end = base + vertices.size();
    parts.push_back({.shape = {.firstVertex = begin,
                               .vertexCount = end - begin,
                               .form = form,
                               .isClosed = true,
                               .middle = scenePlace(box.center()),
                               .halfExtent = scenePlace(box.sizes() / 2),
                               .radius = box.diagonal().norm() / 2},
                     .look = look,
                     .object = std::nullopt,
                     .turnsAbout = std::nullopt});
    begin = end;
    return parts.back();
}

} // namespace idiophone
