#include "Editor/OrbitCamera.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr float halfFieldRadians = 14 * std::numbers::pi_v<float> / 180; // of the window's height
constexpr float farthestZoom = 0.2f, nearestZoom = 20;
constexpr float margin = 1.04f;
constexpr float thinnest = 1e-4f; // metres: a scene without depth still has a distance
constexpr float lowestElevation = 0.03f, highestElevation = 1.5f;

ScenePlace cross(const ScenePlace& a, const ScenePlace& b) {
    return {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};
}

float dot(const ScenePlace& a, const ScenePlace& b) {
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

} // namespace

void OrbitCamera::lookAt(const ScenePlace& lowest, const ScenePlace& highest) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
        middle[axis] = (lowest[axis] + highest[axis]) / 2;
        half[axis] = std::max((highest[axis] - lowest[axis]) / 2, thinnest);
    }
}

void OrbitCamera::turnBy(float aroundRadians, float upRadians) {
    around = std::remainder(around + aroundRadians, 2 * std::numbers::pi_v<float>);
    elevation = std::clamp(elevation + upRadians, lowestElevation, highestElevation);
}

void OrbitCamera::zoomBy(float factor) {
    zoom = std::clamp(zoom * factor, farthestZoom, nearestZoom);
}

void OrbitCamera::reset() {
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

/// At which every corner of the scene's box is within the window.
float OrbitCamera::distance(float aspect) const {
    const auto [right, up, forward] = axes();
    const float slopeY = std::tan(halfFieldRadians), slopeX = slopeY * aspect;
    float farEnough = 0;
    for (unsigned corner = 0; corner < 8; ++corner) {
        ScenePlace place = half;
        for (std::size_t axis = 0; axis < 3; ++axis)
            if ((corner >> axis) & 1)
                place[axis] = -place[axis];
        farEnough = std::max({farEnough, std::abs(dot(place, right)) / slopeX - dot(place, forward),
                              std::abs(dot(place, up)) / slopeY - dot(place, forward)});
    }
    return margin * farEnough / zoom;
}

ScenePlace OrbitCamera::eye(float aspect) const {
    const auto forward = axes().forward;
    const float far = distance(aspect);
    return {middle[0] - far * forward[0], middle[1] - far * forward[1],
            middle[2] - far * forward[2]};
}

std::array<float, 16> OrbitCamera::viewProjection(float aspect) const {
    const auto [right, up, forward] = axes();
    const auto from = eye(aspect);
    const float reach = std::hypot(half[0], half[1], half[2]);
    const float far = distance(aspect) + 1.1f * reach;
    const float near = std::max(distance(aspect) - 1.1f * reach, far / 2000);
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
