// Places and shapes of a glTF file's bodies in a scene, whose z points up.
#pragma once

#include "Gltf/RigidBodies.h"

#include <Eigen/Geometry>
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

/// Returns points whose convex hull is that of all the body's colliders, in the coordinates of a
/// pose.
std::vector<Eigen::Vector3d>
pointsAround(const GltfDocument& document, const GltfRigidBody& body, const PlacedPose& pose);

} // namespace idiophone
