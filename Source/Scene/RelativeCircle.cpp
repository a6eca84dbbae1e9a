#include "Scene/RelativeCircle.h"

#include <cmath>

namespace idiophone {
namespace {

constexpr int maximumSteps = 12;
constexpr double precision = 1e-6; // radians

double fromAxis(const btVector3& point) {
    return std::sqrt(point.x() * point.x() + point.y() * point.y());
}

/// Returns the direction that divides the chord by the weights of its ends.
Direction
between(const Direction& low, double weightLow, const Direction& high, double weightHigh) {
    const double cosine = weightLow * low.cosine + weightHigh * high.cosine;
    const double sine = weightLow * low.sine + weightHigh * high.sine;
    const double length = std::sqrt(cosine * cosine + sine * sine);
    return {cosine / length, sine / length};
}

} // namespace

RelativeCircle::RelativeCircle(const RoundRing& one, const RoundRing& other)
    : otherRadius(other.radius) {
    const btTransform pose = other.pose.inverse() * one.pose;
    centre = pose.getOrigin();
    across = one.radius * pose.getBasis().getColumn(0);
    up = one.radius * pose.getBasis().getColumn(1);
}

double RelativeCircle::squaredDistance(const Direction& direction) const {
    const btVector3 point = at(direction);
    const double away = fromAxis(point) - otherRadius;
    return away * away + point.z() * point.z();
}

/// Returns half the derivative of the squared distance by the angle.
double RelativeCircle::slope(const Direction& direction) const {
    const btVector3 point = at(direction);
    const btVector3 along = direction.cosine * up - direction.sine * across;
    const double away = fromAxis(point);
    const double stretch = away > 0 ? 1 - otherRadius / away : 0;
    return stretch * (point.x() * along.x() + point.y() * along.y()) + point.z() * along.z();
}

// The Illinois method: as the secant method, but an end that stays counts half, so that both ends
// converge. Without a change of sign it halves the chord.
Direction RelativeCircle::minimumBetween(Direction low, Direction high) const {
    double slopeLow = slope(low), slopeHigh = slope(high);
    Direction middle;
    for (int step = 0; step < maximumSteps; ++step) {
        const bool isBracketed = slopeLow < 0 && slopeHigh > 0;
        const auto before = middle;
        middle = between(low, isBracketed ? slopeHigh : 1, high, isBracketed ? -slopeLow : 1);
        if (std::abs(middle.cosine - before.cosine) + std::abs(middle.sine - before.sine) <
            precision)
            break;
        const double slopeMiddle = slope(middle);
        if (slopeMiddle < 0) {
            low = middle;
            slopeLow = slopeMiddle;
            slopeHigh /= 2;
        } else {
            high = middle;
            slopeHigh = slopeMiddle;
            slopeLow /= 2;
        }
    }
    return middle;
}

} // namespace idiophone
