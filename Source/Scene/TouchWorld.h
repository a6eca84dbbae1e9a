// Bullet's world and solver for many small bodies that lie on each other.
#pragma once

#include <btBulletDynamicsCommon.h>
#include <vector>

namespace idiophone {

/// Bullet's boxes are 2 cm larger than a contact reaches, and bodies whose boxes overlap sleep only
/// together, so that a heap of small bodies never sleeps. Here boxes end where contacts do, and
/// bodies that touch sleep together.
class TouchWorld final : public btDiscreteDynamicsWorld {
public:
    using btDiscreteDynamicsWorld::btDiscreteDynamicsWorld;

    /// Wakes the bodies that may lie on a body, which is about to be removed.
    void wakeBeside(const btCollisionObject& body);
    void updateAabbs() override;

protected:
    void calculateSimulationIslands() override;
    void updateActivationState(btScalar stepSeconds) override;
};

/// Leaves out pairs that do not touch, and rows of friction with a coefficient of 0.
class TouchSolver final : public btSequentialImpulseConstraintSolver {
protected:
    void convertContacts(btPersistentManifold** pairs,
                         int count,
                         const btContactSolverInfo& how) override;
    /// Pushes bodies apart as Bullet does, but without the counter that all solvers share.
    void solveGroupCacheFriendlySplitImpulseIterations(btCollisionObject**,
                                                       int,
                                                       btPersistentManifold**,
                                                       int,
                                                       btTypedConstraint**,
                                                       int,
                                                       const btContactSolverInfo& how,
                                                       btIDebugDraw*) override;

private:
    bool push(const btSolverConstraint& row);

    std::vector<btPersistentManifold*> touching;
};

} // namespace idiophone
