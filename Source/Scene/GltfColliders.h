// Places and shapes of a glTF file's bodies in a scene, whose z points up.
#pragma once

#include "Gltf/GltfMeshes.h"
#include "Gltf/RigidBodies.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <optional>
#include <vector>

namespace idiophone {

/// Returns the turn that makes glTF's y the scene's z.
Eigen::Matrix3d zUpFromYUp();

/// A node's place in the scene without its scale.
struct PlacedPose {
    Eigen::Isometry3d worldFromBody = Eigen::Isometry3d::Identity();
    double scale = 1; ///< the mean of its axes
};

PlacedPose placedPose(const Eigen::Affine3d& transform);

struct ColliderSurface {
    std::vector<Eigen::Vector3d> points;   ///< their convex hull is that of all colliders
    std::vector<std::array<int, 3>> faces; ///< of a single mesh that is not a convex hull, or none

    bool operator==(const ColliderSurface&) const = default;
};

/// Returns the body's colliders in the coordinates of a pose. `meshes` are the document's.
/// Subtracts their points from `pointsLeft`, and returns nothing if they are more: a small file can
/// repeat a mesh many times.
std::optional<ColliderSurface> surfaceOf(const GltfDocument& document,
                                         const std::vector<GltfPart>& meshes,
                                         const GltfRigidBody& body,
                                         const PlacedPose& pose,
                                         std::size_t& pointsLeft);

} // namespace idiophone
