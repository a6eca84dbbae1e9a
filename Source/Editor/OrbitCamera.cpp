#include "Editor/OrbitCamera.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

namespace idiophone {
namespace {

constexpr float halfFieldRadians = 14 * std::numbers::pi_v<float> / 180; // half, vertical
constexpr float minimumZoom = 0.2f, maximumZoom = 20;
constexpr float margin = 1.06f;
constexpr float maximumMove = 1;
constexpr float thinnest = 1e-4f; // metres; keeps a distance from a scene without depth
constexpr float lowestElevation = 0.03f, highestElevation = 1.5f;

using Eigen::Vector3f;

} // namespace

void OrbitCamera::lookAt(std::vector<ScenePlace> points) {
    seen = std::move(points);
    Eigen::AlignedBox3f box;
    for (const auto& point : seen)
        box.extend(vectorOf(point));
    middle = box.center();
    reach = std::max(box.diagonal().norm() / 2, thinnest);
}

void OrbitCamera::turnBy(float aroundRadians, float upRadians) {
    around = std::remainder(around + aroundRadians, 2 * std::numbers::pi_v<float>);
    elevation = std::clamp(elevation + upRadians, lowestElevation, highestElevation);
}

void OrbitCamera::zoomBy(float factor) {
    zoom = std::clamp(zoom * factor, minimumZoom, maximumZoom);
}

void OrbitCamera::moveBy(float right, float up) {
    movedRight = std::clamp(movedRight + right / zoom, -maximumMove, maximumMove);
    movedUp = std::clamp(movedUp + up / zoom, -maximumMove, maximumMove);
}

void OrbitCamera::reset() {
    movedRight = movedUp = 0;
    around = initialAround;
    elevation = initialElevation;
    zoom = 1;
}

OrbitCamera::Axes OrbitCamera::axes() const {
    const Vector3f forward(std::cos(elevation) * std::sin(-around),
                           std::cos(elevation) * std::cos(around), -std::sin(elevation));
    const Vector3f right(std::cos(around), std::sin(around), 0);
    return {right, right.cross(forward), forward};
}

/// Moves each of the four frustum planes until it touches a point. Two opposite planes meet in an
/// edge: the eye cannot be nearer than this edge.
OrbitCamera::Eye OrbitCamera::place(float aspect) const {
    const auto [right, up, forward] = axes();
    const float slopeY = std::tan(halfFieldRadians) / margin, slopeX = slopeY * aspect;
    constexpr float none = std::numeric_limits<float>::max();
    float fromLeft = none, fromRight = -none, fromBelow = none, fromAbove = -none;
    for (const auto& point : seen) {
        const auto at = vectorOf(point);
        const float x = at.dot(right), y = at.dot(up), z = at.dot(forward);
        fromLeft = std::min(fromLeft, x + slopeX * z);
        fromRight = std::max(fromRight, x - slopeX * z);
        fromBelow = std::min(fromBelow, y + slopeY * z);
        fromAbove = std::max(fromAbove, y - slopeY * z);
    }
    const float z = std::min((fromLeft - fromRight) / slopeX, (fromBelow - fromAbove) / slopeY) / 2;
    const float whole = std::max(middle.dot(forward) - z, thinnest), depth = whole / zoom;
    const float height = 2 * slopeY * whole;
    const float x = (fromLeft + fromRight) / 2 - movedRight * height;
    const float y = (fromBelow + fromAbove) / 2 - movedUp * height;
    const float along = middle.dot(forward) - depth;
    return {.place = x * right + y * up + along * forward, .depthOfMiddle = depth};
}

ScenePlace OrbitCamera::eye(float aspect) const {
    return scenePlace(place(aspect).place);
}

std::array<float, 16> OrbitCamera::viewProjection(float aspect) const {
    const auto [right, up, forward] = axes();
    const Eye from = place(aspect);
    const float far = from.depthOfMiddle + 1.1f * reach;
    const float near = std::max(from.depthOfMiddle - 1.1f * reach, far / 2000);
    const float scaleY = 1 / std::tan(halfFieldRadians), scaleX = scaleY / aspect;
    const float depthScale = (far + near) / (far - near);
    const float depthShift = -2 * far * near / (far - near);
    std::array<float, 16> result{};
    Eigen::Map<Eigen::Matrix4f> matrix(result.data());
    const auto row = [&](int index, const Vector3f& axis, float shift) {
        matrix.row(index) << axis.transpose(), shift - axis.dot(from.place);
    };
    row(0, scaleX * right, 0);
    row(1, scaleY * up, 0);
    row(2, depthScale * forward, depthShift);
    row(3, forward, 0);
    return result;
}

ViewRay OrbitCamera::rayThrough(float x, float y, float aspect) const {
    const auto [right, up, forward] = axes();
    const float sideways = x * std::tan(halfFieldRadians) * aspect;
    const float upwards = y * std::tan(halfFieldRadians);
    return {.origin = eye(aspect),
            .direction = scenePlace(forward + sideways * right + upwards * up)};
}

} // namespace idiophone
