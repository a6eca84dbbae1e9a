// A tree of bounding boxes around the faces of a mesh. It counts faces that are close to each
// other.
#pragma once

#include "Mesh/Mesh.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// The cost of a search for each face's neighbours in the tree.
struct BoxSearch {
    std::size_t pairs = 0; ///< pairs of faces whose bounding boxes overlap or touch
    std::size_t boxes = 0; ///< visited boxes; good meshes need fewer than 100 per face
};

/// Each node halves its faces along the axis on which the box centres spread most. libigl, CGAL,
/// Eigen and Bullet split by box sizes, by alternating axes or by the mean of the centres. Their
/// trees separate some faces late or never.
class BoxTree {
public:
    /// A node's descendants follow it directly.
    struct Node {
        Eigen::AlignedBox3d box;
        std::size_t after = 0; ///< index of the first node after this node's descendants
        std::size_t face = 0;  ///< valid for leaves only
        bool isLeaf = false;
    };

    /// Takes O(n log n) time for n faces. Indices must be valid, coordinates finite.
    explicit BoxTree(const Mesh& mesh);

    /// The first node is the root. Empty if the mesh has no faces.
    std::span<const Node> nodes() const { return allNodes; }

    /// Returns nothing if a count exceeds its limit in `most`. Takes about 10 ns per visited box.
    std::optional<BoxSearch> touchingFaces(const BoxSearch& most) const;

private:
    void build(std::span<std::size_t> faces, std::span<const Eigen::AlignedBox3d> boxes);

    std::vector<Node> allNodes;
};

} // namespace idiophone
