// Solves the groups of touching bodies of a step on several threads.
#pragma once

#include "Scene/TouchWorld.h"

#include <deque>
#include <vector>

namespace idiophone {

class WorkTeam;

/// Groups have no moving body in common, so that the results do not depend on the team.
class SharedSolver final : public btConstraintSolver {
public:
    /// `sharingTeam` outlives it. It may be null.
    explicit SharedSolver(WorkTeam* sharingTeam);

    /// Keeps the group until `allSolved`.
    btScalar solveGroup(btCollisionObject** bodies,
                        int bodyCount,
                        btPersistentManifold** pairs,
                        int pairCount,
                        btTypedConstraint**,
                        int,
                        const btContactSolverInfo&,
                        btIDebugDraw*,
                        btDispatcher*) override;
    void allSolved(const btContactSolverInfo& how, btIDebugDraw*) override;
    void reset() override {}
    btConstraintSolverType getSolverType() const override { return BT_SEQUENTIAL_IMPULSE_SOLVER; }

private:
    struct Group {
        int firstBody = 0; ///< in `bodiesOfGroups`
        int bodyCount = 0;
        btPersistentManifold** pairs = nullptr;
        int pairCount = 0;
    };

    WorkTeam* team;
    std::vector<btCollisionObject*> bodiesOfGroups;
    std::vector<Group> groups;
    std::deque<TouchSolver> solvers; ///< one for each thread
};

} // namespace idiophone
