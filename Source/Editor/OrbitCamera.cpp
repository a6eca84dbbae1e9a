#include "Editor/OrbitCamera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace idiophone {
namespace {

constexpr float halfFieldRadians = 14 * std::numbers::pi_v<float> / 180; // of the window's height
constexpr float farthestZoom = 0.2f, nearestZoom = 20;
constexpr float margin = 1.06f;
constexpr float farthestMove = 1;
constexpr float thinnest = 1e-4f; // metres: a scene without depth still has a distance
constexpr float lowestElevation = 0.03f, highestElevation = 1.5f;

ScenePlace cross(const ScenePlace& a, const ScenePlace& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

float dot(const ScenePlace& a, const ScenePlace& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

void OrbitCamera::lookAt(std::vector<ScenePlace> points) {
    seen = std::move(points);
    ScenePlace lowest = seen.front(), highest = seen.front();
    for (const auto& point : seen)
        for (std::size_t axis = 0; axis < 3; ++axis) {
            lowest[axis] = std::min(lowest[axis], point[axis]);
            highest[axis] = std::max(highest[axis], point[axis]);
        }
    for (std::size_t axis = 0; axis < 3; ++axis)
        middle[axis] = (lowest[axis] + highest[axis]) / 2;
    reach = std::max(
        std::hypot(highest[0] - lowest[0], highest[1] - lowest[1], highest[2] - lowest[2]) / 2,
        thinnest);
}

void OrbitCamera::turnBy(float aroundRadians, float upRadians) {
    around = std::remainder(around + aroundRadians, 2 * std::numbers::pi_v<float>);
    elevation = std::clamp(elevation + upRadians, lowestElevation, highestElevation);
}

void OrbitCamera::zoomBy(float factor) {
    zoom = std::clamp(zoom * factor, farthestZoom, nearestZoom);
}

void OrbitCamera::moveBy(float right, float up) {
    movedRight = std::clamp(movedRight + right / zoom, -farthestMove, farthestMove);
    movedUp = std::clamp(movedUp + up / zoom, -farthestMove, farthestMove);
}

void OrbitCamera::reset() {
    movedRight = movedUp = 0;
    around = initialAround;
    elevation = initialElevation;
    zoom = 1;
}

OrbitCamera::Axes OrbitCamera::axes() const {
    const ScenePlace forward{std::cos(elevation) * std::sin(-around),
                             std::cos(elevation) * std::cos(around), -std::sin(elevation)};
    const ScenePlace right{std::cos(around), std::sin(around), 0};
    return {right, cross(right, forward), forward};
}

/// Where each of the window's four sides touches a point: two planes facing each other leave the
/// eye a wedge, whose edge is as near as it may come.
OrbitCamera::Eye OrbitCamera::place(float aspect) const {
    const auto [right, up, forward] = axes();
    const float slopeY = std::tan(halfFieldRadians) / margin, slopeX = slopeY * aspect;
    constexpr float none = std::numeric_limits<float>::max();
    float fromLeft = none, fromRight = -none, fromBelow = none, fromAbove = -none;
    for (const auto& point : seen) {
        const float x = dot(point, right), y = dot(point, up), z = dot(point, forward);
        fromLeft = std::min(fromLeft, x + slopeX * z);
        fromRight = std::max(fromRight, x - slopeX * z);
        fromBelow = std::min(fromBelow, y + slopeY * z);
        fromAbove = std::max(fromAbove, y - slopeY * z);
    }
    const float z = std::min((fromLeft - fromRight) / slopeX, (fromBelow - fromAbove) / slopeY) / 2;
    const float whole = std::max(dot(middle, forward) - z, thinnest), depth = whole / zoom;
    const float height = 2 * slopeY * whole;
    const float x = (fromLeft + fromRight) / 2 - movedRight * height;
    const float y = (fromBelow + fromAbove) / 2 - movedUp * height;
    const float along = dot(middle, forward) - depth;
    Eye eye{.depthOfMiddle = depth};
    for (std::size_t axis = 0; axis < 3; ++axis)
        eye.place[axis] = x * right[axis] + y * up[axis] + along * forward[axis];
    return eye;
}

ScenePlace OrbitCamera::eye(float aspect) const {
    return place(aspect).place;
}

std::array<float, 16> OrbitCamera::viewProjection(float aspect) const {
    const auto [right, up, forward] = axes();
    const auto [from, depth] = place(aspect);
    const float far = depth + 1.1f * reach;
    const float near = std::max(depth - 1.1f * reach, far / 2000);
    const float scaleY = 1 / std::tan(halfFieldRadians), scaleX = scaleY / aspect;
    const float depthScale = (far + near) / (far - near);
    const float depthShift = -2 * far * near / (far - near);
    std::array<float, 16> matrix{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
        matrix[4 * axis] = scaleX * right[axis];
        matrix[4 * axis + 1] = scaleY * up[axis];
        matrix[4 * axis + 2] = depthScale * forward[axis];
        matrix[4 * axis + 3] = forward[axis];
    }
    matrix[12] = -scaleX * dot(right, from);
    matrix[13] = -scaleY * dot(up, from);
    matrix[14] = -depthScale * dot(forward, from) + depthShift;
    matrix[15] = -dot(forward, from);
    return matrix;
}

ViewRay OrbitCamera::rayThrough(float x, float y, float aspect) const {
    const auto [right, up, forward] = axes();
    const float sideways = x * std::tan(halfFieldRadians) * aspect;
    const float upwards = y * std::tan(halfFieldRadians);
    ViewRay ray{.origin = eye(aspect), .direction = {}};
    for (std::size_t axis = 0; axis < 3; ++axis)
        ray.direction[axis] = forward[axis] + sideways * right[axis] + upwards * up[axis];
    return ray;
}

std::array<float, 2> OrbitCamera::seenAt(const ScenePlace& place, float aspect) const {
    const auto matrix = viewProjection(aspect);
    const auto row = [&](std::size_t index) {
        return matrix[index] * place[0] + matrix[4 + index] * place[1] +
               matrix[8 + index] * place[2] + matrix[12 + index];
    };
    return {row(0) / row(3), row(1) / row(3)};
}

} // namespace idiophone
