#include "Scene/TouchWorld.h"

#include <BulletCollision/CollisionDispatch/btSimulationIslandManager.h>

namespace idiophone {
namespace {

/// The gap of bodies that lie on each other is smaller: they move by micrometres in a step.
constexpr double touchMetres = 1e-4;

bool areTouching(const btPersistentManifold& pair) {
    for (int k = 0; k < pair.getNumContacts(); ++k)
        if (pair.getContactPoint(k).getDistance() < touchMetres)
            return true;
    return false;
}

} // namespace

void TouchWorld::wakeBeside(const btCollisionObject& body) {
    for (int k = 0; k < getDispatcher()->getNumManifolds(); ++k) {
        const auto& pair = *getDispatcher()->getManifoldByIndexInternal(k);
        if (pair.getBody0() == &body || pair.getBody1() == &body)
            for (const auto* one : {pair.getBody0(), pair.getBody1()})
                one->activate();
    }
}

void TouchWorld::updateAabbs() {
    for (int k = 0; k < m_nonStaticRigidBodies.size(); ++k) {
        auto* body = m_nonStaticRigidBodies[k];
        if (!body->isActive())
            continue;
        const auto& shape = *body->getCollisionShape();
        const double reach = shape.getContactBreakingThreshold(gContactBreakingThreshold);
        btVector3 lowest, highest;
        shape.getAabb(body->getWorldTransform(), lowest, highest);
        const btVector3 margin(reach, reach, reach);
        getBroadphase()->setAabb(body->getBroadphaseHandle(), lowest - margin, highest + margin,
                                 getDispatcher());
    }
}

void TouchWorld::calculateSimulationIslands() {
    auto& islands = *getSimulationIslandManager();
    islands.initUnionFind(m_nonStaticRigidBodies.size());
    int next = 0; // numbers moving bodies in the order in which Bullet stores their islands
    for (int k = 0; k < m_collisionObjects.size(); ++k) {
        m_collisionObjects[k]->setCompanionId(-1); // of the last step's solver
        if (!m_collisionObjects[k]->isStaticObject())
            m_collisionObjects[k]->setIslandTag(next++);
    }
    for (int k = 0; k < getDispatcher()->getNumManifolds(); ++k) {
        const auto& pair = *getDispatcher()->getManifoldByIndexInternal(k);
        const auto &one = *pair.getBody0(), &other = *pair.getBody1();
        if (!one.isStaticObject() && !other.isStaticObject() && areTouching(pair))
            islands.getUnionFind().unite(one.getIslandTag(), other.getIslandTag());
    }
    islands.storeIslandActivationState(this);
}

/// Bullet lets a body that another one woke sleep again as soon as they part, even in the air.
void TouchWorld::updateActivationState(btScalar stepSeconds) {
    for (int k = 0; k < m_nonStaticRigidBodies.size(); ++k)
        if (auto& body = *m_nonStaticRigidBodies[k];
            body.getActivationState() == WANTS_DEACTIVATION &&
            body.getDeactivationTime() < gDeactivationTime)
            body.setActivationState(ACTIVE_TAG);
    btDiscreteDynamicsWorld::updateActivationState(stepSeconds);
}

void TouchSolver::convertContacts(btPersistentManifold** pairs,
                                  int count,
                                  const btContactSolverInfo& how) {
    touching.clear();
    for (int k = 0; k < count; ++k)
        if (areTouching(*pairs[k]))
            touching.push_back(pairs[k]);
    btSequentialImpulseConstraintSolver::convertContacts(touching.data(),
                                                         static_cast<int>(touching.size()), how);
    auto& rows = m_tmpSolverContactRollingFrictionConstraintPool;
    int kept = 0;
    for (int k = 0; k < rows.size(); ++k)
        if (rows[k].m_friction > 0)
            rows[kept++] = rows[k];
    rows.resizeNoInitialize(kept);
}

void TouchSolver::solveGroupCacheFriendlySplitImpulseIterations(btCollisionObject**,
                                                                int,
                                                                btPersistentManifold**,
                                                                int,
                                                                btTypedConstraint**,
                                                                int,
                                                                const btContactSolverInfo& how,
                                                                btIDebugDraw*) {
    const auto& rows = m_tmpSolverContactConstraintPool;
    bool isChanged = true;
    for (int iteration = 0; isChanged && iteration < how.m_numIterations; ++iteration) {
        isChanged = false;
        for (int k = 0; k < rows.size(); ++k)
            if (rows[k].m_rhsPenetration != 0)
                isChanged = push(rows[k]) || isChanged;
    }
}

/// Returns whether the bodies' velocities change.
bool TouchSolver::push(const btSolverConstraint& row) {
    auto& one = m_tmpSolverBodyPool[row.m_solverBodyIdA];
    auto& other = m_tmpSolverBodyPool[row.m_solverBodyIdB];
    btScalar change = row.m_rhsPenetration - btScalar(row.m_appliedPushImpulse) * row.m_cfm;
    change -= (row.m_contactNormal1.dot(one.internalGetPushVelocity()) +
               row.m_relpos1CrossNormal.dot(one.internalGetTurnVelocity())) *
              row.m_jacDiagABInv;
    change -= (row.m_contactNormal2.dot(other.internalGetPushVelocity()) +
               row.m_relpos2CrossNormal.dot(other.internalGetTurnVelocity())) *
              row.m_jacDiagABInv;
    const btScalar before = row.m_appliedPushImpulse;
    const btScalar after = before + change;
    if (after < row.m_lowerLimit)
        change = row.m_lowerLimit - before;
    row.m_appliedPushImpulse = after < row.m_lowerLimit ? row.m_lowerLimit : after;
    one.internalApplyPushImpulse(row.m_contactNormal1 * one.internalGetInvMass(),
                                 row.m_angularComponentA, change);
    other.internalApplyPushImpulse(row.m_contactNormal2 * other.internalGetInvMass(),
                                   row.m_angularComponentB, change);
    return change != 0;
}

} // namespace idiophone
