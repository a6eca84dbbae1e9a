// The distance between two circles in space.
#pragma once

#include "Scene/RingShape.h"

namespace idiophone {

/// A direction in a circle's plane, of length 1.
struct Direction {
    double cosine = 1, sine = 0;
};

/// A circle in the coordinates of another one, in metres.
class RelativeCircle {
public:
    RelativeCircle(const RoundRing& one, const RoundRing& other);

    /// Returns the square of the other circle's distance from the point in a direction.
    double squaredDistance(const Direction& direction) const;
    /// Returns the direction with the minimum distance between two others.
    Direction minimumBetween(Direction low, Direction high) const;

private:
    btVector3 at(const Direction& direction) const {
        return centre + direction.cosine * across + direction.sine * up;
    }
    double slope(const Direction& direction) const;

    double otherRadius;
    btVector3 centre, across, up;
};

} // namespace idiophone
