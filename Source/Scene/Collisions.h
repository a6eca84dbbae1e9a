// Chooses the collision algorithms of bodies.
#pragma once

#include "Scene/RingCollision.h"
#include "Scene/SurfaceShape.h"

namespace idiophone {

/// Bullet's collision algorithms, except those of rings and surfaces.
class Collisions final : public btDefaultCollisionConfiguration {
public:
    btCollisionAlgorithmCreateFunc* getCollisionAlgorithmCreateFunc(int first,
                                                                    int second) override {
        const auto are = [&](auto isFirst, auto isSecond) {
            return isFirst(first) && isSecond(second);
        };
        constexpr auto isConvex = btBroadphaseProxy::isConvex;
        constexpr auto isSurface = [](int type) { return type == TRIANGLE_MESH_SHAPE_PROXYTYPE; };
        if (are(isConvex, isSurface))
            return &onSurface;
        if (are(isSurface, isConvex))
            return &ofSurface;
        if (btBroadphaseProxy::isCompound(first) || btBroadphaseProxy::isCompound(second))
            return &rings;
        return btDefaultCollisionConfiguration::getCollisionAlgorithmCreateFunc(first, second);
    }

private:
    template <bool isSwapped>
    struct Surfaces final : btCollisionAlgorithmCreateFunc {
        btCollisionAlgorithm*
        CreateCollisionAlgorithm(btCollisionAlgorithmConstructionInfo& info,
                                 const btCollisionObjectWrapper* first,
                                 const btCollisionObjectWrapper* second) override {
            void* memory = info.m_dispatcher1->allocateCollisionAlgorithm(sizeof(SurfaceCollision));
            return new (memory) SurfaceCollision(info, first, second, isSwapped);
        }
    };

    Surfaces<false> onSurface;
    Surfaces<true> ofSurface;
    RingCollisions rings{*this};
};

} // namespace idiophone
