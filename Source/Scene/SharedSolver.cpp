#include "Scene/SharedSolver.h"

#include "Object/WorkTeam.h"

#include <algorithm>
#include <functional>

namespace idiophone {

SharedSolver::SharedSolver(WorkTeam* sharingTeam) : team(sharingTeam), solvers(threadsOf(team)) {}

btScalar SharedSolver::solveGroup(btCollisionObject** bodies,
                                  int bodyCount,
                                  btPersistentManifold** pairs,
                                  int pairCount,
                                  btTypedConstraint**,
                                  int,
                                  const btContactSolverInfo&,
                                  btIDebugDraw*,
                                  btDispatcher*) {
    if (bodyCount == 0) // Bullet ends with the joints that no group has
        return 0;
    groups.push_back({.firstBody = static_cast<int>(bodiesOfGroups.size()),
                      .bodyCount = bodyCount,
                      .pairs = pairs,
                      .pairCount = pairCount});
    bodiesOfGroups.insert(bodiesOfGroups.end(), bodies, bodies + bodyCount);
    return 0;
}

void SharedSolver::allSolved(const btContactSolverInfo& how, btIDebugDraw*) {
    std::ranges::stable_sort(groups, std::greater(), &Group::pairCount);
    shareItems(team, groups.size(), [&](std::size_t k, std::size_t thread) {
        const auto& group = groups[k];
        solvers[thread].solveGroup(bodiesOfGroups.data() + group.firstBody, group.bodyCount,
                                   group.pairs, group.pairCount, nullptr, 0, how, nullptr, nullptr);
    });
    groups.clear();
    bodiesOfGroups.clear();
}

} // namespace idiophone
