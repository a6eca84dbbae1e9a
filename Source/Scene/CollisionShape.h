// Bodies as Bullet sees them.
#pragma once

#include "Scene/RigidBodyModel.h"

#include <btBulletDynamicsCommon.h>
#include <memory>
#include <vector>

namespace idiophone {

/// A shape in body coordinates together with what it is made of. Immutable; bodies of a kind share
/// it, on one thread: Bullet's shapes cache. Not for the audio thread, nor does it check the model,
/// which makeRigidBodyModel has.
class CollisionShape {
public:
    explicit CollisionShape(const RigidBodyModel& model);

    btCollisionShape* shape() const { return root; }

private:
    template <class Shape, class... Arguments>
    Shape* own(Arguments&&... arguments);
    btCollisionShape* hull(const std::vector<Eigen::Vector3d>& points);
    btCollisionShape* ring(const RigidBodyModel& model);
    btCollisionShape* sectorHulls(const RigidBodyModel& model,
                                  const std::vector<Eigen::Vector3d>& outer);
    btCollisionShape* round(const RigidBodyModel& model);
    btCollisionShape* ground(const RigidBodyModel& model);
    btCollisionShape* surface(const RigidBodyModel& model);

    std::vector<std::unique_ptr<btTriangleMesh>> meshes;
    std::vector<std::unique_ptr<btOptimizedBvh>> trees;
    std::vector<std::unique_ptr<btTriangleInfoMap>> edges;
    std::vector<std::unique_ptr<btCollisionShape>> shapes; ///< destroyed before what they refer to
    btCollisionShape* root = nullptr;
};

} // namespace idiophone
