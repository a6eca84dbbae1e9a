#include "Scene/PairLimit.h"

#include "Object/WorkTeam.h"
#include "Scene/RigidWorld.h"
#include "Scene/RingCollision.h"

#include <algorithm>

namespace idiophone {

thread_local PairLimit::Collided PairLimit::collided;

PairLimit::PairLimit(btCollisionConfiguration* configuration, WorkTeam* sharingTeam)
    : btCollisionDispatcher(configuration), team(sharingTeam), changesOfThreads(threadsOf(team)) {
    setNearCallback(collide);
}

bool PairLimit::needBroadphaseCollision(btBroadphaseProxy* first, btBroadphaseProxy* second) const {
    if ((first->m_collisionFilterGroup & second->m_collisionFilterMask) == 0 ||
        (second->m_collisionFilterGroup & first->m_collisionFilterMask) == 0)
        return false;
    isReached = isReached || bodies.getNumOverlappingPairs() >= RigidWorld::maximumPairs;
    return !isReached;
}

void PairLimit::collide(btBroadphasePair& pair,
                        btCollisionDispatcher& dispatcher,
                        const btDispatcherInfo& how) {
    auto& limit = static_cast<PairLimit&>(dispatcher);
    limit.isReached = limit.isReached || limit.getNumManifolds() >= RigidWorld::maximumPairs;
    if (!limit.isReached)
        defaultNearCallback(pair, dispatcher, how);
}

void PairLimit::dispatchAllCollisionPairs(btOverlappingPairCache* pairs,
                                          const btDispatcherInfo& how,
                                          btDispatcher* dispatcher) {
    auto& all = pairs->getOverlappingPairArray();
    shared.clear();
    for (int k = 0; k < all.size() && changesOfThreads.size() > 1; ++k)
        if (all[k].m_algorithm != nullptr && isOfRings(*all[k].m_algorithm))
            shared.push_back(k);
    if (shared.empty()) {
        btCollisionDispatcher::dispatchAllCollisionPairs(pairs, how, dispatcher);
        return;
    }
    team->runAll(shared.size(), [&](std::size_t k, std::size_t thread) {
        collided = {.pair = shared[k], .changes = &changesOfThreads[thread]};
        defaultNearCallback(all[shared[k]], *this, how);
        collided = {};
    });
    for (int k = 0, next = 0; k < all.size(); ++k) {
        if (next < std::ssize(shared) && shared[next] == k) {
            ++next;
            continue;
        }
        collided = {.pair = k, .changes = &changesOfThreads[0]};
        collide(all[k], *this, how);
        collided = {};
    }
    enterChanges();
}

void PairLimit::enterChanges() {
    for (auto& ofThread : changesOfThreads) {
        changes.insert(changes.end(), ofThread.begin(), ofThread.end());
        ofThread.clear();
    }
    std::ranges::stable_sort(changes, {}, &Change::pair);
    for (const auto& change : changes) {
        if (!change.isNew) {
            btCollisionDispatcher::releaseManifold(change.contacts);
            continue;
        }
        change.contacts->m_index1a = m_manifoldsPtr.size();
        m_manifoldsPtr.push_back(change.contacts);
    }
    changes.clear();
}

btPersistentManifold* PairLimit::getNewManifold(const btCollisionObject* first,
                                                const btCollisionObject* second) {
    const WorkTeam::Turn turn(team); // Bullet has one pool
    auto* contacts = btCollisionDispatcher::getNewManifold(first, second);
    if (collided.changes != nullptr) {
        m_manifoldsPtr.pop_back();
        collided.changes->push_back({.pair = collided.pair, .contacts = contacts, .isNew = true});
    }
    return contacts;
}

void PairLimit::releaseManifold(btPersistentManifold* contacts) {
    if (collided.changes != nullptr)
        collided.changes->push_back({.pair = collided.pair, .contacts = contacts, .isNew = false});
    else
        btCollisionDispatcher::releaseManifold(contacts);
}

void* PairLimit::allocateCollisionAlgorithm(int bytes) {
    const WorkTeam::Turn turn(team);
    return btCollisionDispatcher::allocateCollisionAlgorithm(bytes);
}

void PairLimit::freeCollisionAlgorithm(void* algorithm) {
    const WorkTeam::Turn turn(team);
    btCollisionDispatcher::freeCollisionAlgorithm(algorithm);
}

} // namespace idiophone
