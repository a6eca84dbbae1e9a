// Bullet's collision shape of a body.
#pragma once

#include "Scene/RigidBodyModel.h"

#include <btBulletDynamicsCommon.h>
#include <memory>
#include <vector>

namespace idiophone {

class SurfaceShape;

/// A shape in body coordinates, with the parts that it consists of. Immutable. Bodies of a kind
/// share it on one thread only, because Bullet's shapes hold caches. Not for the audio thread.
/// Expects a model that makeRigidBodyModel has checked.
class CollisionShape {
public:
    explicit CollisionShape(const RigidBodyModel& model);

    btCollisionShape* shape() const { return root; }
    /// Returns null if the form is not `surface`.
    const SurfaceShape* surface() const { return surfaceShape; }

private:
    template <class Shape, class... Arguments>
    Shape* own(Arguments&&... arguments);
    btCollisionShape* hull(const std::vector<Eigen::Vector3d>& points);
    btCollisionShape* ring(const RigidBodyModel& model);
    btCollisionShape* sectorHulls(const RigidBodyModel& model,
                                  const std::vector<Eigen::Vector3d>& outer);
    btCollisionShape* round(const RigidBodyModel& model);
    btCollisionShape* ground(const RigidBodyModel& model);
    btCollisionShape* meshOf(const RigidBodyModel& model);

    std::vector<std::unique_ptr<btTriangleMesh>> meshes;
    std::vector<std::unique_ptr<btTriangleInfoMap>> edges;
    std::vector<std::unique_ptr<btCollisionShape>> shapes; ///< last: destroyed before their data
    btCollisionShape* root = nullptr;
    const SurfaceShape* surfaceShape = nullptr;
};

} // namespace idiophone
