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

/// Adds the corners of faces.
void addMesh(ColliderSurface& surface,
             const Mesh& mesh,
             const Eigen::Affine3d& place,
             bool hasFaces) {
    for (const auto face : mesh.faces.rowwise()) {
        std::array<int, 3> corners{};
        for (int k = 0; k < 3; ++k) {
            corners[static_cast<std::size_t>(k)] = static_cast<int>(surface.points.size());
            surface.points.push_back(place * Eigen::Vector3d(mesh.vertices.row(face(k))));
            if (!surface.points.back().allFinite())
                surface.points.back().setZero();
        }
        if (hasFaces)
            surface.faces.push_back(corners);
    }
}

Eigen::Affine3d nodeFromScene(const GltfDocument& document, int node) {
    for (const auto& placed : document.nodes())
        if (placed.node == node && placed.transform.linear().determinant() != 0)
            return placed.transform.inverse();
    return Eigen::Affine3d::Identity();
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

std::optional<ColliderSurface> surfaceOf(const GltfDocument& document,
                                         const std::vector<GltfPart>& meshes,
                                         const GltfRigidBody& body,
                                         const PlacedPose& pose,
                                         std::size_t& pointsLeft) {
    const Eigen::Isometry3d bodyFromWorld = pose.worldFromBody.inverse();
    ColliderSurface surface;
    const auto spend = [&](std::size_t points) {
        const bool isAffordable = points <= pointsLeft;
        pointsLeft -= isAffordable ? points : 0;
        return isAffordable;
    };
    for (const auto& collider : body.colliders) {
        const Eigen::Affine3d bodyFromCollider =
            bodyFromWorld *
            Eigen::Affine3d(zUpFromYUp() * document.nodes()[collider.place].transform);
        if (collider.form != GltfCollider::Form::mesh) {
            const auto points = pointsOf(collider);
            if (!spend(points.size()))
                return {};
            for (const auto& point : points)
                surface.points.push_back(bodyFromCollider * point);
            continue;
        }
        const bool hasFaces = body.colliders.size() == 1 && !collider.isConvexHull;
        for (const auto& part : meshes) {
            if (part.node != collider.meshNode)
                continue;
            if (!spend(3 * static_cast<std::size_t>(part.mesh.faceCount())))
                return {};
            addMesh(surface, part.mesh, bodyFromCollider * nodeFromScene(document, part.node),
                    hasFaces);
        }
    }
    return surface;
}

} // namespace idiophone
