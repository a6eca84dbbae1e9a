#include "Editor/ObjectStand.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace idiophone {
namespace {

using Vector = Eigen::Vector3f;

constexpr Appearance steel{Finish::metal, {0.62f, 0.64f, 0.67f}};
constexpr Appearance felt{Finish::cloth, {0.24f, 0.26f, 0.30f}};
constexpr Appearance pip{Finish::plastic, {0.95f, 0.94f, 0.90f}};

constexpr int roundSides = 48, legSides = 20;

/// The largest radius about the object's axis in a share of its height from one end.
float radiusAt(const SceneObject& object, std::span<const SceneVertex> vertices, bool atTop) {
    constexpr float share = 0.12f;
    const auto middle = vectorOf(object.middle);
    float widest = 0;
    for (const auto& vertex : vertices) {
        const Vector away = vectorOf(vertex.place) - middle;
        if ((atTop ? away.z() : -away.z()) > (1 - 2 * share) * object.halfExtent[2])
            widest = std::max(widest, away.head<2>().norm());
    }
    return widest;
}

/// A bell hangs from a slender frame.
float addGallows(FurnitureParts& parts, const Vector& middle, const Vector& half) {
    const float radius = half.x(), top = middle.z() + half.z(), beam = top + 0.3f * radius;
    const float floor = middle.z() - half.z() - 0.4f * radius, thick = 0.05f * radius;
    const float aside = 1.45f * radius, foot = floor + thick;
    const auto at = [&](float x, float y, float z) {
        return Vector(middle.x() + x, middle.y() + y, z);
    };
    parts.addRod(at(0, 0, top - 0.05f * radius), at(0, 0, beam), 0.6f * thick, 0.6f * thick,
                 legSides);
    parts.addRod(at(-aside - thick, 0, beam), at(aside + thick, 0, beam), thick, thick, legSides);
    for (const float side : {-aside, aside}) {
        parts.addRod(at(side, 0, foot), at(side, 0, beam), thick, thick, legSides);
        parts.addRod(at(side, -0.8f * radius, foot), at(side, 0.8f * radius, foot), thick, thick,
                     legSides);
    }
    parts.finish(steel, Form::turned);
    return floor;
}

float addRingBelow(FurnitureParts& parts, const Vector& middle, const Vector& half, float radius) {
    const float thickness = std::clamp(0.16f * half.x(), 0.004f, 0.03f);
    const float ring = std::max(radius, 0.25f * half.x());
    const float bottom = middle.z() - half.z();
    parts.addRing({middle.x(), middle.y(), bottom - 0.1f * thickness}, ring + 0.4f * thickness,
                  thickness, roundSides);
    parts.finish(felt);
    return bottom - 0.6f * thickness;
}

/// Cones of felt under a sheet, near its rest lines.
float addPegs(FurnitureParts& parts, const Vector& middle, const Vector& half, bool isRound) {
    const float extent = std::max(half.x(), half.y());
    const float bottom = middle.z() - half.z(), floor = bottom - 0.16f * extent;
    const float wide = 0.06f * extent, narrow = 0.02f * extent;
    std::vector<Eigen::Vector2f> places;
    if (isRound)
        for (int i = 0; i < 3; ++i) {
            const float angle = 1.57f + 2.0944f * float(i);
            places.emplace_back(0.97f * std::cos(angle), 0.97f * std::sin(angle));
        }
    else
        places = {{-0.55f, -0.55f}, {0.55f, -0.55f}, {-0.55f, 0.55f}, {0.55f, 0.55f}};
    for (const auto& at : places) {
        const float x = middle.x() + at.x() * half.x(), y = middle.y() + at.y() * half.y();
        parts.addRod({x, y, floor}, {x, y, bottom}, wide, narrow, legSides);
    }
    parts.finish(felt);
    return floor;
}

constexpr Appearance walnut{Finish::wood, {0.34f, 0.20f, 0.12f}};

/// Whether something is held, and it is less than half as long as the object.
bool isSmall(const Eigen::AlignedBox3f& clamp, const Vector& half) {
    return !clamp.isEmpty() && clamp.diagonal().norm() < half.norm();
}

/// A post on a board holds what is clamped.
float addPost(FurnitureParts& parts,
              const Vector& middle,
              const Vector& half,
              const Eigen::AlignedBox3f& clamp) {
    const float pad = 0.06f * half.norm(), floor = middle.z() - half.z() - 0.4f * half.norm();
    const Vector at = clamp.center(), size = clamp.sizes() + Vector::Constant(2 * pad);
    const float board = floor + pad;
    parts.addBeam({at.x(), at.y(), board}, {at.x(), at.y(), clamp.max().z() + pad / 2}, size.x(),
                  size.y(), Vector::UnitY());
    parts.finish(steel);
    const float aside = half.x() + 2 * pad;
    parts.addBeam({middle.x() - aside, middle.y(), floor + pad / 2},
                  {middle.x() + aside, middle.y(), floor + pad / 2}, 2 * half.y() + 4 * pad, pad);
    parts.finish(walnut);
    return floor;
}

bool isSheet(const SceneObject& object) {
    const auto& half = object.halfExtent;
    return half[2] < 0.12f * std::min(half[0], half[1]);
}

} // namespace

float addStand(FurnitureParts& parts,
               const SceneObject& object,
               std::span<const SceneVertex> vertices,
               Finish finish,
               const Eigen::AlignedBox3f& clamp) {
    const auto middle = vectorOf(object.middle), half = vectorOf(object.halfExtent);
    if (isSmall(clamp, half))
        return addPost(parts, middle, half, clamp);
    if (object.form == Form::turned && !isSheet(object)) {
        constexpr float flare = 1.25f;
        const float above = radiusAt(object, vertices, true);
        const float below = radiusAt(object, vertices, false);
        // A shallow gong lies, and a tall bottle stands.
        const float slenderness = half.z() / half.x();
        if (below > flare * above && slenderness > 0.4f && slenderness < 2.5f)
            return addGallows(parts, middle, half);
        if (above > flare * below)
            return addRingBelow(parts, middle, half, below);
        if (half.z() < half.x())
            return addPegs(parts, middle, half, true);
    } else if (isSheet(object)) {
        if (finish == Finish::wood && isTableTop(object))
            return addLegs(parts, object);
        return addPegs(parts, middle, half, object.form == Form::turned);
    }
    // Anything else stands on a pad of felt.
    const float thickness = 0.03f * std::max(half.x(), half.y());
    const float bottom = middle.z() - half.z();
    parts.addDisc({middle.x(), middle.y(), bottom - thickness / 2}, Vector::UnitZ(),
                  1.15f * half.head<2>().norm(), thickness, roundSides);
    parts.finish(felt);
    return bottom - thickness;
}

bool isTableTop(const SceneObject& object) {
    constexpr float smallest = 0.25f, largest = 0.75f; // half the longer side, in metres
    const float longer = std::max(object.halfExtent[0], object.halfExtent[1]);
    return object.form == Form::box && isSheet(object) && longer > smallest && longer < largest;
}

float addLegs(FurnitureParts& parts, const SceneObject& top) {
    const auto middle = vectorOf(top.middle), half = vectorOf(top.halfExtent);
    const float leg = 0.045f * half.head<2>().norm(), bottom = middle.z() - half.z();
    const float floor = bottom - 0.9f * half.head<2>().minCoeff();
    for (const float x : {-1.0f, 1.0f})
        for (const float y : {-1.0f, 1.0f}) {
            const Vector at(middle.x() + x * (half.x() - 2.4f * leg),
                            middle.y() + y * (half.y() - 2.4f * leg), bottom);
            parts.addRod({at.x() + 0.8f * x * leg, at.y() + 0.8f * y * leg, floor}, at, 0.45f * leg,
                         0.8f * leg, legSides);
        }
    parts.finish({Finish::wood, {0.50f, 0.35f, 0.22f}});
    return floor;
}

bool isDie(const SceneObject& object) {
    const auto [smallest, largest] = std::ranges::minmax(object.halfExtent);
    return object.form == Form::box && smallest > 0.97f * largest;
}

void addPips(FurnitureParts& parts, const SceneObject& die) {
    const auto middle = vectorOf(die.middle);
    const float half = die.halfExtent[0], spread = 0.5f * half, radius = 0.19f * half;
    const auto addSide = [&](const Vector& out, int count) {
        const Vector right = out.unitOrthogonal(), up = out.cross(right);
        const auto add = [&](float x, float y) {
            parts.addDisc(middle + half * out + spread * (x * right + y * up), out, radius,
                          0.02f * half, legSides);
        };
        if (count % 2 == 1)
            add(0, 0);
        if (count >= 2) {
            add(-1, -1);
            add(1, 1);
        }
        if (count >= 4) {
            add(-1, 1);
            add(1, -1);
        }
        if (count == 6) {
            add(-1, 0);
            add(1, 0);
        }
    };
    for (int axis = 0; axis < 3; ++axis) {
        addSide(Vector::Unit(axis), axis + 1);
        addSide(-Vector::Unit(axis), 6 - axis);
    }
    parts.finish(pip);
}

} // namespace idiophone
