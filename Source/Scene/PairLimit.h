// Bounds the pairs of bodies that Bullet collides, and lets several threads share them.
#pragma once

#include <btBulletDynamicsCommon.h>
#include <vector>

namespace idiophone {

class WorkTeam;

/// Gives Bullet its usual pairs up to a maximum number: pairs of nearby bodies and of their nearby
/// parts. Threads share the pairs with a ring that have met before. Contacts that begin and end
/// enter the list in the order of the pairs, so that Bullet solves them as without a team.
class PairLimit final : public btOverlapFilterCallback, public btCollisionDispatcher {
public:
    /// `sharingTeam` outlives it. It may be null.
    PairLimit(btCollisionConfiguration* configuration, WorkTeam* sharingTeam);

    bool needBroadphaseCollision(btBroadphaseProxy* first,
                                 btBroadphaseProxy* second) const override;
    void dispatchAllCollisionPairs(btOverlappingPairCache* pairs,
                                   const btDispatcherInfo& how,
                                   btDispatcher* dispatcher) override;

    // The rest is called by collision algorithms, on any thread of the team.
    btPersistentManifold* getNewManifold(const btCollisionObject* first,
                                         const btCollisionObject* second) override;
    void releaseManifold(btPersistentManifold* contacts) override;
    void* allocateCollisionAlgorithm(int bytes) override;
    void freeCollisionAlgorithm(void* algorithm) override;

    btHashedOverlappingPairCache bodies;
    mutable bool isReached = false; // mutable: Bullet calls a const function

private:
    /// Contacts that a pair has begun or ended.
    struct Change {
        int pair = 0;
        btPersistentManifold* contacts = nullptr;
        bool isNew = false;
    };

    /// The pair that a thread collides.
    struct Collided {
        int pair = 0;
        std::vector<Change>* changes = nullptr; ///< null: changes enter the list at once
    };
    static thread_local Collided collided;

    static void
    collide(btBroadphasePair& pair, btCollisionDispatcher& dispatcher, const btDispatcherInfo& how);
    void enterChanges();

    WorkTeam* team;
    std::vector<int> shared;
    std::vector<std::vector<Change>> changesOfThreads;
    std::vector<Change> changes; ///< scratch
};

} // namespace idiophone
