// The faces of a surface as Bullet looks for them.
#pragma once

#include "Geometry/BoxTree.h"
#include "Scene/BulletMath.h"

namespace idiophone {

/// A BoxTree in Bullet's form, so that a search takes what was counted in one. Trees that Bullet
/// makes of its own accord widen every box to 2 mm or round it to a share of the whole surface, so
/// that of small faces, or beside one far away, all are neighbours; and they halve uneven surfaces
/// by chance.
class SurfaceTree final : public btOptimizedBvh {
public:
    /// A mesh whose indices are valid and whose coordinates are finite.
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
