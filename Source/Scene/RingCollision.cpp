#include "Scene/RingCollision.h"

#include "Scene/RelativeCircle.h"
#include "Scene/RingShape.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btConvexConcaveCollisionAlgorithm.h>
#include <BulletCollision/CollisionShapes/btConvexPolyhedron.h>
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <typeinfo>

namespace idiophone {
namespace {

const RingShape* ringOf(const btCollisionObjectWrapper& body) {
    return dynamic_cast<const RingShape*>(body.getCollisionShape());
}

RoundRing ringIn(const btCollisionObjectWrapper& body, const btTransform& from) {
    RoundRing ring = static_cast<const RingShape*>(body.getCollisionShape())->ring();
    ring.pose = from * body.getWorldTransform() * ring.pose;
    return ring;
}

constexpr std::size_t spokes = 24; // of a circle, to find contacts between them

const auto directions = [] {
    std::array<Direction, spokes> all;
    for (std::size_t k = 0; k < spokes; ++k) {
        const double angle = 2 * std::numbers::pi * static_cast<double>(k) / spokes;
        all[k] = {std::cos(angle), std::sin(angle)};
    }
    return all;
}();

/// An algorithm with up to four contacts, which last from step to step.
class RingAlgorithm : public btCollisionAlgorithm {
public:
    RingAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                  const btCollisionObjectWrapper& first,
                  const btCollisionObjectWrapper& second)
        : btCollisionAlgorithm(info),
          contacts(m_dispatcher->getNewManifold(first.getCollisionObject(),
                                                second.getCollisionObject())) {}
    ~RingAlgorithm() override { m_dispatcher->releaseManifold(contacts); }
    RingAlgorithm(const RingAlgorithm&) = delete;
    RingAlgorithm& operator=(const RingAlgorithm&) = delete;

    btScalar calculateTimeOfImpact(btCollisionObject*,
                                   btCollisionObject*,
                                   const btDispatcherInfo&,
                                   btManifoldResult*) override {
        return 1;
    }
    void getAllContactManifolds(btManifoldArray& all) override { all.push_back(contacts); }

protected:
    void refresh(btManifoldResult& result) const {
        result.setPersistentManifold(contacts);
        result.refreshContactPoints();
    }

    /// A ring that touches at several points does not roll.
    void dropRolling() const {
        int touching = 0;
        for (int k = 0; k < contacts->getNumContacts(); ++k)
            touching += contacts->getContactPoint(k).getDistance() < 0 ? 1 : 0;
        for (int k = 0; k < contacts->getNumContacts() && touching > 1; ++k)
            contacts->getContactPoint(k).m_combinedRollingFriction = 0;
    }

    btPersistentManifold* contacts;
};

/// Contacts lie at the local minima of the distance between the circles.
class RingPair final : public RingAlgorithm {
public:
    using RingAlgorithm::RingAlgorithm;

    void processCollision(const btCollisionObjectWrapper* first,
                          const btCollisionObjectWrapper* second,
                          const btDispatcherInfo&,
                          btManifoldResult* result) override {
        refresh(*result);
        const auto world = btTransform::getIdentity();
        const auto one = ringIn(*first, world), other = ringIn(*second, world);
        const double reach =
            one.sectionRadius + other.sectionRadius + contacts->getContactBreakingThreshold();
        if (areApart(one, other, reach))
            return;
        const RelativeCircle circle(one, other);
        std::array<double, spokes> squares{};
        for (std::size_t k = 0; k < spokes; ++k)
            squares[k] = circle.squaredDistance(directions[k]);
        const double farthest = reach + std::numbers::pi / spokes * one.radius; // of a sample
        for (std::size_t k = 0; k < spokes; ++k) {
            const auto next = (k + 1) % spokes, last = (k + spokes - 1) % spokes;
            if (squares[k] < farthest * farthest && squares[k] <= squares[next] &&
                squares[k] <= squares[last])
                touch(one, other, circle.minimumBetween(directions[last], directions[next]),
                      *result);
        }
        dropRolling();
    }

private:
    static bool areApart(const RoundRing& one, const RoundRing& other, double reach) {
        const btVector3 between = other.centre() - one.centre();
        return between.length() > one.radius + other.radius + reach ||
               std::abs(between.dot(one.axis())) > other.extentAlong(one.axis()) + reach ||
               std::abs(between.dot(other.axis())) > one.extentAlong(other.axis()) + reach;
    }

    static void touch(const RoundRing& one,
                      const RoundRing& other,
                      const Direction& direction,
                      btManifoldResult& result) {
        const auto point = one.at(direction.cosine, direction.sine);
        const auto nearest = other.nearest(point);
        const double distance = point.distance(nearest);
        const btVector3 normal =
            distance > SIMD_EPSILON ? (point - nearest) / distance : one.axis();
        result.addContactPoint(normal, nearest + other.sectionRadius * normal,
                               distance - one.sectionRadius - other.sectionRadius);
    }
};

/// A ring on a plane or over a face of a hull. Elsewhere its capsules collide with the hull.
class RingOnFaces final : public RingAlgorithm {
public:
    RingOnFaces(const btCollisionAlgorithmConstructionInfo& info,
                const btCollisionObjectWrapper& first,
                const btCollisionObjectWrapper& second,
                btCollisionAlgorithmCreateFunc& ofCapsules)
        : RingAlgorithm(info, first, second), makeCapsules(ofCapsules),
          isRingFirst(ringOf(first) != nullptr) {
        const auto& shape = *(isRingFirst ? second : first).getCollisionShape();
        if (shape.getShapeType() == STATIC_PLANE_PROXYTYPE) {
            const auto& plane = static_cast<const btStaticPlaneShape&>(shape);
            faces.push_back({plane.getPlaneNormal(), plane.getPlaneConstant()});
            return;
        }
        margin = shape.getMargin();
        const auto& hull = *static_cast<const btConvexHullShape&>(shape).getConvexPolyhedron();
        for (int k = 0; k < hull.m_faces.size(); ++k) {
            const auto& plane = hull.m_faces[k].m_plane;
            faces.push_back({btVector3(plane[0], plane[1], plane[2]), -plane[3]});
        }
    }
    ~RingOnFaces() override { dropCapsules(); }

    static bool hasFaces(const btCollisionShape& shape) {
        return shape.getShapeType() == STATIC_PLANE_PROXYTYPE ||
               (shape.getShapeType() == CONVEX_HULL_SHAPE_PROXYTYPE &&
                static_cast<const btConvexHullShape&>(shape).getConvexPolyhedron() != nullptr);
    }

    void processCollision(const btCollisionObjectWrapper* first,
                          const btCollisionObjectWrapper* second,
                          const btDispatcherInfo& how,
                          btManifoldResult* result) override {
        const auto& body = isRingFirst ? *second : *first;
        const auto ring =
            ringIn(isRingFirst ? *first : *second, body.getWorldTransform().inverse());
        const auto heightOver = [&](const Face& face) {
            return face.height(ring.centre()) - ring.extentAlong(face.normal);
        };
        const auto& nearest = *std::ranges::max_element(faces, {}, heightOver);
        const bool isFar = heightOver(nearest) >
                           margin + ring.sectionRadius + contacts->getContactBreakingThreshold();
        if (!isFar && (heightOver(nearest) < 0 || !isWithin(ring, nearest)) && faces.size() > 1) {
            contacts->clearManifold();
            if (capsules == nullptr) {
                btCollisionAlgorithmConstructionInfo info; // its other constructor sets less
                info.m_dispatcher1 = m_dispatcher;
                capsules = makeCapsules.CreateCollisionAlgorithm(info, first, second);
            }
            capsules->processCollision(first, second, how, result);
            return;
        }
        dropCapsules();
        refresh(*result);
        if (!isFar)
            touch(ring, nearest, body.getWorldTransform(), *result);
        dropRolling();
    }

    void getAllContactManifolds(btManifoldArray& all) override {
        RingAlgorithm::getAllContactManifolds(all);
        if (capsules != nullptr)
            capsules->getAllContactManifolds(all);
    }

private:
    struct Face {
        btVector3 normal;
        double offset;
        double height(const btVector3& point) const { return normal.dot(point) - offset; }
    };

    /// A ring that tilts less than this share of its radius touches at three fixed points.
    static constexpr double flatShare = 2e-4;

    void dropCapsules() {
        if (capsules == nullptr)
            return;
        capsules->~btCollisionAlgorithm();
        m_dispatcher->freeCollisionAlgorithm(capsules);
        capsules = nullptr;
    }

    /// Returns whether the circle's projection on the face's plane lies within the face.
    bool isWithin(const RoundRing& ring, const Face& face) const {
        return std::ranges::all_of(faces, [&](const Face& side) {
            const double along = side.normal.dot(face.normal);
            const btVector3 across = side.normal - along * face.normal;
            return &side == &face ||
                   across.dot(ring.centre()) + ring.extentAlong(across) + along * face.offset <=
                       side.offset;
        });
    }

    /// Adds the lowest point and two of three fixed points, or all three if the ring lies flat.
    void touch(const RoundRing& ring,
               const Face& face,
               const btTransform& worldFromBody,
               btManifoldResult& result) const {
        const btVector3 down = face.normal * -1 * ring.pose.getBasis(); // in the ring's coordinates
        const double slope = std::hypot(down.x(), down.y());
        const bool isFlat = slope < flatShare;
        const double sine60 = std::sqrt(0.75);
        for (const auto& [cosine, sine] :
             {std::array{1.0, 0.0}, std::array{-0.5, sine60}, std::array{-0.5, -sine60}})
            if (isFlat || cosine * down.x() + sine * down.y() < slope / 2)
                touchAt(ring.at(cosine, sine), ring.sectionRadius, face, worldFromBody, result);
        if (!isFlat)
            touchAt(ring.at(down.x() / slope, down.y() / slope), ring.sectionRadius, face,
                    worldFromBody, result);
    }

    void touchAt(const btVector3& point,
                 double sectionRadius,
                 const Face& face,
                 const btTransform& worldFromBody,
                 btManifoldResult& result) const {
        const double height = face.height(point) - margin;
        const double distance = height - sectionRadius;
        if (distance > contacts->getContactBreakingThreshold())
            return;
        const btVector3 normal = worldFromBody.getBasis() * face.normal;
        const btVector3 foot = worldFromBody(point - height * face.normal);
        if (isRingFirst)
            result.addContactPoint(normal, foot, distance);
        else
            result.addContactPoint(-normal, foot + distance * normal, distance);
    }

    btCollisionAlgorithmCreateFunc& makeCapsules;
    btCollisionAlgorithm* capsules = nullptr; ///< null while the ring is over a face
    std::vector<Face> faces;                  ///< not empty
    double margin = 0;                        ///< the body extends by it beyond its faces
    bool isRingFirst;
};

template <class Algorithm, class... Arguments>
btCollisionAlgorithm* makeAlgorithm(const btCollisionAlgorithmConstructionInfo& info,
                                    const btCollisionObjectWrapper& first,
                                    const btCollisionObjectWrapper& second,
                                    Arguments&... arguments) {
    // Bullet's pool has room for its own largest algorithm.
    static_assert(sizeof(Algorithm) <= sizeof(btConvexConcaveCollisionAlgorithm));
    void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(Algorithm));
    return new (memory) Algorithm(info, first, second, arguments...);
}

} // namespace

btCollisionAlgorithm*
RingCollisions::CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                         const btCollisionObjectWrapper* first,
                                         const btCollisionObjectWrapper* second) {
    auto& usual = *configuration.btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(
        first->getCollisionShape()->getShapeType(), second->getCollisionShape()->getShapeType());
    const bool isFirst = ringOf(*first) != nullptr, isSecond = ringOf(*second) != nullptr;
    if (isFirst && isSecond)
        return makeAlgorithm<RingPair>(info, *first, *second);
    if ((isFirst && RingOnFaces::hasFaces(*second->getCollisionShape())) ||
        (isSecond && RingOnFaces::hasFaces(*first->getCollisionShape())))
        return makeAlgorithm<RingOnFaces>(info, *first, *second, usual);
    return usual.CreateCollisionAlgorithm(info, first, second);
}

bool isOfRings(const btCollisionAlgorithm& algorithm) {
    return typeid(algorithm) == typeid(RingPair) || typeid(algorithm) == typeid(RingOnFaces);
}

} // namespace idiophone
