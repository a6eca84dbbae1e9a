// A ring's collision shape: a circle with a round section.
#pragma once

#include <btBulletDynamicsCommon.h>

namespace idiophone {

/// A circle with a round section, in metres.
struct RoundRing {
    btTransform pose; ///< from the ring's own coordinates: its axis is z
    double radius = 0;
    double sectionRadius = 0;

    const btVector3& centre() const { return pose.getOrigin(); }
    btVector3 axis() const { return pose.getBasis().getColumn(2); }
    btVector3 at(double cosine, double sine) const {
        return pose(btVector3(radius * cosine, radius * sine, 0));
    }
    /// Returns the point of the circle nearest to a point.
    btVector3 nearest(const btVector3& point) const;
    /// Returns half the circle's extent along a vector.
    double extentAlong(const btVector3& direction) const;
};

/// A chain of capsules for all bodies except rings and fixed bodies with faces, which collide with
/// the circle (RingCollision.h).
class RingShape final : public btCompoundShape {
public:
    /// `ring` is in body coordinates.
    explicit RingShape(const RoundRing& ring);

    const RoundRing& ring() const { return own; }

private:
    RoundRing own;
    btCapsuleShape capsule;
};

} // namespace idiophone
