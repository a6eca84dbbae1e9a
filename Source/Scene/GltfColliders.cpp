#include "Scene/GltfColliders.h"

#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

/// Returns points around a collider, in its node's own space.
std::vector<Eigen::Vector3d> pointsOf(const GltfCollider& collider) {
    using Form = GltfCollider::Form;
    constexpr int around = 24;
    const Eigen::Vector3d half = collider.sizesMetres / 2;
    std::vector<Eigen::Vector3d> points;
    if (collider.form == Form::box || collider.form == Form::plane) {
        for (int corner = 0; corner < 8; ++corner)
            points.push_back(half.cwiseProduct(
                Eigen::Vector3d(corner & 1 ? 1 : -1, corner & 2 ? 1 : -1, corner & 4 ? 1 : -1)));
        return points;
    }
    const auto addRing = [&](double radius, double y) {
        for (int k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * k / around;
            points.emplace_back(radius * std::cos(angle), y, radius * std::sin(angle));
        }
    };
    if (collider.form == Form::cylinder) {
        addRing(collider.topRatio * half.x(), half.y());
        addRing(collider.bottomRatio * half.x(), -half.y());
        return points;
    }
    // A sphere is a capsule without a middle.
    for (const double side : {-1.0, 1.0}) {
        const double radius = half.x() * (side > 0 ? collider.topRatio : collider.bottomRatio);
        for (int ring = 0; ring <= around / 4; ++ring) {
            const double angle = std::numbers::pi / 2 * ring / (around / 4);
            addRing(radius * std::cos(angle), side * (half.y() - radius * (1 - std::sin(angle))));
        }
    }
    return points;
}

} // namespace

Eigen::Matrix3d zUpFromYUp() {
    return Eigen::AngleAxisd(std::numbers::pi / 2, Eigen::Vector3d::UnitX()).toRotationMatrix();
}

PlacedPose placedPose(const Eigen::Affine3d& transform) {
    const Eigen::Affine3d placed = zUpFromYUp() * transform;
    Eigen::Matrix3d turn, stretch;
    placed.computeRotationScaling(&turn, &stretch);
    PlacedPose pose;
    pose.worldFromBody.linear() = turn;
    pose.worldFromBody.translation() = placed.translation();
    pose.scale = std::cbrt(std::abs(stretch.determinant()));
    return pose;
}

std::vector<Eigen::Vector3d>
pointsAround(const GltfDocument& document, const GltfRigidBody& body, const PlacedPose& pose) {
    const Eigen::Isometry3d bodyFromWorld = pose.worldFromBody.inverse();
    std::vector<Eigen::Vector3d> points;
    for (const auto& collider : body.colliders)
        for (const auto& point : pointsOf(collider))
            points.push_back(bodyFromWorld *
                             (zUpFromYUp() * (document.nodes()[collider.place].transform * point)));
    return points;
}

} // namespace idiophone
