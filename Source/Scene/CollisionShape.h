// Bodies as Bullet sees them.
#pragma once

#include "Scene/BodyModel.h"

#include <btBulletDynamicsCommon.h>
#include <memory>
#include <vector>

namespace idiophone {

/// A shape in body coordinates together with what it is made of. Immutable; bodies of a kind share
/// it.
class CollisionShape {
public:
    explicit CollisionShape(const BodyModel& model);

    btCollisionShape* shape() const { return root; }

private:
    template <class Shape, class... Arguments>
    Shape* own(Arguments&&... arguments);
    btCollisionShape* hull(const std::vector<Eigen::Vector3d>& points);
    btCollisionShape* ring(const BodyModel& model);
    btCollisionShape* sectorHulls(const BodyModel& model,
                                  const std::vector<Eigen::Vector3d>& outer);
    btCollisionShape* round(const BodyModel& model);
    btCollisionShape* ground(const BodyModel& model);
    btCollisionShape* surface(const BodyModel& model);

    std::vector<std::unique_ptr<btTriangleMesh>> meshes;
    std::vector<std::unique_ptr<btTriangleInfoMap>> edges;
    std::vector<std::unique_ptr<btCollisionShape>> shapes; ///< destroyed before what they refer to
    btCollisionShape* root = nullptr;
};

} // namespace idiophone
