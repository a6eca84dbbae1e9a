// Finds the contacts of rings in closed form.
#pragma once

#include <btBulletDynamicsCommon.h>
#include <vector>

namespace idiophone {

/// Makes the collision algorithms of ring shapes. A ring meets another ring, a plane, or a hull
/// whose face reaches beyond the ring in closed form. `others` makes all other algorithms, and must
/// outlive it.
class RingCollisions final : public btCollisionAlgorithmCreateFunc {
public:
    explicit RingCollisions(btDefaultCollisionConfiguration& others) : configuration(others) {}

    btCollisionAlgorithm* CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                                   const btCollisionObjectWrapper* first,
                                                   const btCollisionObjectWrapper* second) override;

private:
    btDefaultCollisionConfiguration& configuration;
};

/// Returns whether `RingCollisions` made an algorithm that handles a ring in closed form. Several
/// threads may collide several such pairs, because they write only to their own contacts.
bool isOfRings(const btCollisionAlgorithm& algorithm);

} // namespace idiophone
