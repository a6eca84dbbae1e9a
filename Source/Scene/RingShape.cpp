#include "Scene/RingShape.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr int capsules = 16;
constexpr double capsuleTurn = 2 * std::numbers::pi / capsules;

} // namespace

btVector3 RoundRing::nearest(const btVector3& point) const {
    const btVector3 away = point - centre();
    const btVector3 normal = axis();
    const btVector3 along = away - normal.dot(away) * normal;
    const double length = along.length();
    return length > 0 ? centre() + along * (radius / length) : at(1, 0);
}

double RoundRing::extentAlong(const btVector3& direction) const {
    const double along = direction.dot(axis());
    return radius * std::sqrt(std::max(direction.length2() - along * along, 0.0));
}

// The polygon is as long as the circle, so that the polygon lies half inside the circle.
RingShape::RingShape(const RoundRing& ring)
    : own(ring), capsule(ring.sectionRadius, capsuleTurn * ring.radius) {
    const double radius = capsuleTurn * ring.radius / 2 / std::tan(capsuleTurn / 2);
    for (int k = 0; k < capsules; ++k) { // Bullet's capsules lie along y
        const double angle = capsuleTurn * k;
        addChildShape(ring.pose * btTransform(btQuaternion(btVector3(0, 0, 1), angle),
                                              btVector3(radius * std::cos(angle),
                                                        radius * std::sin(angle), 0)),
                      &capsule);
    }
}

} // namespace idiophone
