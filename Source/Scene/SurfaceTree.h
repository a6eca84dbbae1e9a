// The tree of a surface's faces in which Bullet looks for collisions.
#pragma once

#include "Geometry/BoxTree.h"
#include "Scene/BulletMath.h"

namespace idiophone {

/// A BoxTree in Bullet's format, so that Bullet's searches cost as much as BoxTree counted.
/// Bullet's own trees widen boxes to 2 mm or round them to a fraction of the whole surface. Small
/// faces, or all faces beside a distant one, then count as neighbours. Bullet's trees also split
/// uneven surfaces badly.
class SurfaceTree final : public btOptimizedBvh {
public:
    /// Expects valid indices and finite coordinates.
    explicit SurfaceTree(const Mesh& mesh) {
        const BoxTree tree(mesh);
        m_useQuantization = false;
        m_curNodeIndex = static_cast<int>(tree.nodes().size());
        m_contiguousNodes.resize(m_curNodeIndex);
        for (int k = 0; k < m_curNodeIndex; ++k) {
            const auto& from = tree.nodes()[static_cast<std::size_t>(k)];
            auto& node = m_contiguousNodes[k];
            node.m_aabbMinOrg = toBullet(from.box.min());
            node.m_aabbMaxOrg = toBullet(from.box.max());
            node.m_escapeIndex = from.isLeaf ? -1 : static_cast<int>(from.after) - k;
            node.m_subPart = 0;
            node.m_triangleIndex = static_cast<int>(from.face);
        }
    }
};

} // namespace idiophone
