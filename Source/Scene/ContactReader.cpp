#include "Scene/ContactReader.h"

#include "Scene/BulletMath.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace idiophone {
namespace {

/// Slower approaches belong to a lasting contact: 5 mm/s is a fall of 1.3 µm. So do approaches
/// below the speed that two steps of gravity add.
constexpr double slowestStrikeMetresPerSecond = 0.005;
constexpr double stepsOfRest = 2;
/// An impact passed on through bodies in contact changes their speed by at least this many steps of
/// gravity. The weight of resting bodies changes it by less.
constexpr double stepsOfGravity = 20;

bool moves(const btRigidBody& body) {
    return !body.isStaticObject() && body.isActive();
}

} // namespace

/// A contact point with pressure in this step, from the second body's surface to the first's.
struct ContactReader::Point {
    Eigen::Vector3d place;   ///< in the world, in metres
    Eigen::Vector3d normal;  ///< unit vector from the second to the first
    Eigen::Vector3d impulse; ///< [N s] on the first
    double normalImpulse;    ///< [N s]
    double approach;         ///< m/s, before the step
    double depthMetres;      ///< overlap at the beginning of the step
    double effectiveMassKg;

    double speedChange() const { return normalImpulse / effectiveMassKg; }
};

/// The points of a lasting contact, weighted by their pressure.
struct ContactReader::Pressing {
    double newtonSeconds = 0;
    Eigen::Vector3d weightedPlace = Eigen::Vector3d::Zero();
    Eigen::Vector3d weightedNormal = Eigen::Vector3d::Zero();

    void add(const Point& point) {
        newtonSeconds += point.normalImpulse;
        weightedPlace += point.normalImpulse * point.place;
        weightedNormal += point.normalImpulse * point.normal;
    }
};

ContactReader::ContactReader(double step, double gravityMetresPerSecond2)
    : stepSeconds(step), restingSpeed(gravityMetresPerSecond2 * step),
      slowestStrike(std::max(slowestStrikeMetresPerSecond, stepsOfRest * restingSpeed)) {}

void ContactReader::begin(double seconds) {
    startSeconds = seconds;
    collected.clear();
    lasting.clear();
}

void ContactReader::read(const btPersistentManifold& manifold, std::span<const BodyInStep> bodies) {
    const auto firstNumber = static_cast<std::size_t>(manifold.getBody0()->getUserIndex());
    const auto secondNumber = static_cast<std::size_t>(manifold.getBody1()->getUserIndex());
    const Pair pair{firstNumber, secondNumber, bodies[firstNumber], bodies[secondNumber]};
    if (!moves(*pair.first.rigid) && !moves(*pair.second.rigid))
        return; // the contact is from the step in which both bodies fell asleep

    Pressing pressing;
    for (int k = 0; k < manifold.getNumContacts(); ++k) {
        const auto& contact = manifold.getContactPoint(k);
        // The solver handles overlapping points only. Other points still hold the impulse of an
        // earlier step.
        if (contact.getDistance() > 0 || !(contact.getAppliedImpulse() > 0))
            continue;
        const auto point = pointOf(contact, pair);
        if (point.approach > slowestStrike || point.speedChange() > stepsOfGravity * restingSpeed)
            addImpact(point, pair);
        else
            pressing.add(point);
    }
    if (pressing.newtonSeconds > 0)
        addTouch(pressing, pair);
}

ContactReader::Point ContactReader::pointOf(const btManifoldPoint& contact, const Pair& pair) {
    const auto &first = pair.first, &second = pair.second;
    const auto place = contact.getPositionWorldOnB();
    Point point{.place = toEigen(place),
                .normal = toEigen(contact.m_normalWorldOnB),
                .impulse = {},
                .normalImpulse = contact.getAppliedImpulse(),
                .approach = 0,
                .depthMetres = -contact.getDistance(),
                .effectiveMassKg = 0};
    point.effectiveMassKg =
        1 / (first.rigid->computeImpulseDenominator(place, contact.m_normalWorldOnB) +
             second.rigid->computeImpulseDenominator(place, contact.m_normalWorldOnB));
    point.impulse = point.normalImpulse * point.normal +
                    contact.m_appliedImpulseLateral1 * toEigen(contact.m_lateralFrictionDir1) +
                    contact.m_appliedImpulseLateral2 * toEigen(contact.m_lateralFrictionDir2);
    point.approach =
        point.normal.dot(second.velocityAt(point.place) - first.velocityAt(point.place));
    return point;
}

void ContactReader::addTouch(const Pressing& pressing, const Pair& pair) {
    const auto& [firstNumber, secondNumber, first, second] = pair;
    const Eigen::Vector3d middle = pressing.weightedPlace / pressing.newtonSeconds;
    const Eigen::Vector3d normal = pressing.weightedNormal.normalized();
    const Eigen::Vector3d apart = first.velocityAt(middle) - second.velocityAt(middle);
    const Eigen::Vector3d turning = first.spin - second.spin;
    const double radius = relativeRadiusMetres(*first.model, *second.model);
    Touch touch{.bodies = {firstNumber, secondNumber},
                .pointMetres = {first.worldFromMesh.inverse() * middle,
                                second.worldFromMesh.inverse() * middle},
                .inward = {first.worldFromMesh.linear().transpose() * normal,
                           second.worldFromMesh.linear().transpose() * -normal},
                .forceNewtons = pressing.newtonSeconds / stepSeconds,
                .slideMetresPerSecond = (apart - apart.dot(normal) * normal).norm(),
                .rollMetresPerSecond = radius * (turning - turning.dot(normal) * normal).norm()};
    if (firstNumber > secondNumber) {
        std::swap(touch.bodies[0], touch.bodies[1]);
        std::swap(touch.pointMetres[0], touch.pointMetres[1]);
        std::swap(touch.inward[0], touch.inward[1]);
    }
    lasting.push_back(touch);
}

void ContactReader::addImpact(const Point& point, const Pair& pair) {
    const auto& [firstNumber, secondNumber, first, second] = pair;
    const double speed = point.approach > slowestStrike ? point.approach : point.speedChange();
    // Since the bodies met, they have approached by the depth.
    const double sinceSeconds =
        point.approach > 0 ? std::min(point.depthMetres / point.approach, stepSeconds) : 0;
    Impact impact{.seconds = std::max(startSeconds - sinceSeconds, 0.0),
                  .body = firstNumber,
                  .other = secondNumber,
                  .pointMetres = first.worldFromMesh.inverse() * point.place,
                  .impulseNewtonSeconds = first.worldFromMesh.linear().transpose() * point.impulse,
                  .contactSeconds =
                      contactSeconds(*first.model, *second.model, point.effectiveMassKg, speed),
                  .speedMetresPerSecond = speed};
    collected.push_back(impact);
    std::swap(impact.body, impact.other);
    impact.pointMetres = second.worldFromMesh.inverse() * point.place;
    impact.impulseNewtonSeconds = second.worldFromMesh.linear().transpose() * -point.impulse;
    collected.push_back(impact);
}

void ContactReader::finish() {
    std::ranges::stable_sort(collected, {}, [](const Impact& impact) {
        return std::tuple(impact.seconds, impact.body, impact.other);
    });
    std::ranges::stable_sort(lasting, {}, &Touch::bodies);
}

} // namespace idiophone
