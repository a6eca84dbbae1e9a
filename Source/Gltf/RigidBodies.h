// SPDX-License-Identifier: Apache-2.0
// The rigid bodies of a glTF file (KHR_physics_rigid_bodies, KHR_implicit_shapes), and what each of
// them sounds like (KHR_audio_rigid_bodies).
#pragma once

#include "Gltf/AudioRigidBodies.h"

namespace idiophone {

struct GltfCollider {
    enum class Form { box, sphere, cylinder, capsule, plane, mesh };
    std::size_t place = 0; ///< its node: an index into `GltfDocument::nodes`
    Form form = Form::box;
    /// The box, or the box around another shape, which stands along y. A plane is infinite, and its
    /// normal is y.
    Eigen::Vector3d sizesMetres{1, 1, 1};
    double topRatio = 1; ///< top radius over the greater one; of round shapes
    double bottomRatio = 1;
    int meshNode = -1; ///< of a mesh: the node in the file
    bool isConvexHull = false;
};

/// A body that moves, or a collider that stands still.
struct GltfRigidBody {
    std::size_t place = 0; ///< an index into `GltfDocument::nodes`
    bool isFixed = false;
    /// The mass of a moving body, if the file has it. The moments are all 0 if it has none.
    std::optional<MassProperties> mass = {};
    Eigen::Vector3d velocityMetresPerSecond = Eigen::Vector3d::Zero(); ///< in the node's own space
    Eigen::Vector3d spinRadiansPerSecond = Eigen::Vector3d::Zero();    ///< in the node's own space
    std::vector<GltfCollider> colliders = {};                          ///< not empty
    std::optional<double> friction = {}, restitution = {};
    std::optional<std::size_t> soundPlace = {};  ///< the node with its modal model, as `place`
    std::optional<std::size_t> finishPlace = {}; ///< the node with its acoustic surface
};

struct GltfRigidBodies {
    std::vector<GltfRigidBody> bodies;
    std::string notes; ///< sentences for the user: what is left out; may be empty
};

/// Returns whether the file says that it has rigid bodies.
bool hasRigidBodies(const GltfDocument& document);

/// Returns the bodies of the document's scene. Bodies without a collider are left out, as are
/// joints and triggers. The error is the end of a sentence that begins with the file's name.
Result<GltfRigidBodies> rigidBodies(const GltfDocument& document, const AudioRigidBodies& audio);

} // namespace idiophone
