#include "Scene/RigidWorld.h"

#include "Scene/BulletMath.h"
#include "Scene/CollisionShape.h"
#include "Scene/Collisions.h"
#include "Scene/ContactReader.h"
#include "Scene/PairLimit.h"
#include "Scene/SharedSolver.h"
#include "Scene/SurfaceShape.h"
#include "Scene/TouchWorld.h"

#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <algorithm>
#include <cmath>
#include <deque>

namespace idiophone {
namespace {

constexpr double slowestReboundMetresPerSecond = 0.02; // slower falls do not rebound
constexpr double sleepMetresPerSecond = 0.003;
constexpr double sleepRadiansPerSecond = 0.1; // rings at rest on a ring jitter by up to 0.03
constexpr int solverIterations = 30;
/// A resting body overlaps by the distance that it falls in this many steps. Otherwise it would
/// touch only in every other step.
constexpr double restingStepsOfFall = 2;
constexpr double sleepSeconds = 0.5; ///< of rest before a group of bodies sleeps
constexpr double treeMarginMetres = 0.002;
constexpr double microsecondsOfPair = 5; // measured

/// Bullet calls this for every new contact. It adds the rolling frictions of both bodies and lets
/// them pass over the inner edges of a mesh.
bool adjustContact(btManifoldPoint& point,
                   const btCollisionObjectWrapper* first,
                   int firstPart,
                   int firstIndex,
                   const btCollisionObjectWrapper* second,
                   int secondPart,
                   int secondIndex) {
    const auto of = [](const btCollisionObjectWrapper* wrapper) {
        return static_cast<const RigidBodyModel*>(wrapper->getCollisionObject()->getUserPointer());
    };
    if (of(first) == nullptr || of(second) == nullptr)
        return false;
    point.m_combinedRollingFriction =
        of(first)->rollingFrictionMetres + of(second)->rollingFrictionMetres;
    if (first->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE)
        btAdjustInternalEdgeContacts(point, first, second, firstPart, firstIndex);
    else if (second->getCollisionShape()->getShapeType() == TRIANGLE_SHAPE_PROXYTYPE)
        btAdjustInternalEdgeContacts(point, second, first, secondPart, secondIndex);
    return true;
}

/// Sets the values that Bullet has once for the process. Several worlds may start at once.
bool setGlobals() {
    gContactAddedCallback = adjustContact;
    gDeactivationTime = sleepSeconds;
    gDbvtMargin = treeMarginMetres;
    return true;
}

} // namespace

struct RigidWorld::Implementation {
    Implementation(std::vector<Kind> allKinds,
                   double stepsPerSecond,
                   double gravity,
                   WorkTeam* team)
        : kinds(std::move(allKinds)), stepSeconds(1 / stepsPerSecond),
          dispatcher(&configuration, team), broadphase(&dispatcher.bodies), solver(team),
          world(&dispatcher, &broadphase, &solver, &configuration), reader(stepSeconds, gravity) {
        [[maybe_unused]] static const bool areSet = setGlobals();
        dispatcher.bodies.setOverlapFilterCallback(&dispatcher);
        for (const auto& kind : kinds)
            shapes.emplace_back(*kind.model);
        world.setGravity(btVector3(0, 0, -gravity));
        auto& solving = world.getSolverInfo();
        solving.m_numIterations = solverIterations;
        solving.m_solverMode |= SOLVER_USE_2_FRICTION_DIRECTIONS;
        solving.m_splitImpulse = 1;
        solving.m_splitImpulsePenetrationThreshold = 0; // correct overlap without adding speed
        solving.m_linearSlop = restingStepsOfFall * gravity * stepSeconds * stepSeconds;
        solving.m_restitutionVelocityThreshold = slowestReboundMetresPerSecond;
        solving.m_minimumSolverBatchSize = 1; // small groups stay in the cache
    }

    ~Implementation() {
        for (auto& body : bodies)
            if (body != nullptr)
                world.removeRigidBody(body.get());
    }

    std::vector<Kind> kinds;
    double stepSeconds;
    std::int64_t stepsDone = 0;
    double workDone = 0;
    std::deque<CollisionShape> shapes; ///< by kind
    Collisions configuration;
    PairLimit dispatcher;
    btDbvtBroadphase broadphase;
    SharedSolver solver;
    TouchWorld world;
    std::vector<std::unique_ptr<btRigidBody>> bodies; ///< null without one, or after removal
    std::vector<BodyInStep> inStep;                   ///< by body
    ContactReader reader;
};

RigidWorld::RigidWorld(std::vector<Kind> kinds,
                       double stepsPerSecond,
                       double gravityMetresPerSecond2,
                       WorkTeam* team)
    : implementation(std::make_unique<Implementation>(
          std::move(kinds), stepsPerSecond, gravityMetresPerSecond2, team)) {}

RigidWorld::~RigidWorld() = default;

std::size_t RigidWorld::add(std::size_t kind, const BodyMotion& motion) {
    auto& all = *implementation;
    const auto& model = *all.kinds[kind].model;
    const btVector3 inertia = model.isFixed ? btVector3(0, 0, 0) : toBullet(model.inertiaKgM2);
    btRigidBody::btRigidBodyConstructionInfo info(model.isFixed ? 0 : model.massKg, nullptr,
                                                  all.shapes[kind].shape(), inertia);
    // Bullet multiplies the values of both bodies, which then gives their geometric mean.
    info.m_friction = std::sqrt(model.friction);
    info.m_restitution = std::sqrt(model.restitution);
    info.m_startWorldTransform = toBullet(Eigen::Isometry3d(motion.pose * model.meshFromBody));
    info.m_linearSleepingThreshold = sleepMetresPerSecond;
    info.m_angularSleepingThreshold = sleepRadiansPerSecond;
    auto rigid = std::make_unique<btRigidBody>(info);
    // Solve overlapping contacts only: a contact ahead would brake the fall and spoil the rebound.
    rigid->setContactProcessingThreshold(0);
    rigid->setLinearVelocity(toBullet(motion.velocity));
    rigid->setAngularVelocity(toBullet(motion.spin));
    rigid->setUserIndex(static_cast<int>(all.bodies.size()));
    rigid->setUserPointer(const_cast<RigidBodyModel*>(&model)); // adjustContact only reads it
    rigid->setCollisionFlags(rigid->getCollisionFlags() |
                             btCollisionObject::CF_CUSTOM_MATERIAL_CALLBACK);
    all.world.addRigidBody(rigid.get(), all.kinds[kind].group, all.kinds[kind].collidesWith);
    all.inStep.push_back({.model = &model, .rigid = rigid.get()});
    all.bodies.push_back(std::move(rigid));
    return all.bodies.size() - 1;
}

std::size_t RigidWorld::addAbsent() {
    implementation->bodies.emplace_back();
    implementation->inStep.emplace_back();
    return implementation->bodies.size() - 1;
}

void RigidWorld::remove(std::size_t body) {
    auto& rigid = implementation->bodies[body];
    implementation->world.wakeBeside(*rigid);
    implementation->world.removeRigidBody(rigid.get());
    rigid.reset();
}

BodyMotion RigidWorld::motion(std::size_t body) const {
    const auto& rigid = *implementation->bodies[body];
    const auto& model = *implementation->inStep[body].model;
    return {.pose = toEigen(rigid.getWorldTransform()) * model.meshFromBody.inverse(),
            .velocity = toEigen(rigid.getLinearVelocity()),
            .spin = toEigen(rigid.getAngularVelocity())};
}

Eigen::Vector3d RigidWorld::centre(std::size_t body) const {
    return toEigen(implementation->bodies[body]->getCenterOfMassPosition());
}

void RigidWorld::setVelocity(std::size_t body,
                             const Eigen::Vector3d& velocity,
                             const Eigen::Vector3d& spin) {
    auto& rigid = *implementation->bodies[body];
    rigid.setLinearVelocity(toBullet(velocity));
    rigid.setAngularVelocity(toBullet(spin));
    rigid.activate(true);
}

void RigidWorld::step() {
    auto& all = *implementation;
    for (std::size_t body = 0; body < all.bodies.size(); ++body)
        if (all.bodies[body] != nullptr) {
            const auto before = motion(body);
            auto& now = all.inStep[body];
            now.worldFromMesh = before.pose;
            now.centre = centre(body);
            now.velocity = before.velocity;
            now.spin = before.spin;
            ++all.workDone;
        }
    all.reader.begin(seconds());
    all.world.stepSimulation(all.stepSeconds, 0);
    for (int k = 0; k < all.dispatcher.getNumManifolds(); ++k) {
        all.reader.read(*all.dispatcher.getManifoldByIndexInternal(k), all.inStep);
        all.workDone += microsecondsOfPair;
    }
    all.reader.finish();
    ++all.stepsDone;
}

double RigidWorld::seconds() const {
    return static_cast<double>(implementation->stepsDone) * implementation->stepSeconds;
}

double RigidWorld::stepSeconds() const {
    return implementation->stepSeconds;
}

bool RigidWorld::isCrowded() const {
    return implementation->dispatcher.isReached;
}

double RigidWorld::work() const {
    double sum = implementation->workDone;
    for (const auto& shape : implementation->shapes)
        if (shape.surface() != nullptr)
            sum += shape.surface()->work();
    return sum;
}

std::span<const Impact> RigidWorld::impacts() const {
    return implementation->reader.impacts();
}

std::span<const Touch> RigidWorld::touches() const {
    return implementation->reader.touches();
}

} // namespace idiophone
