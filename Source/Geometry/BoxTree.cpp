#include "Geometry/BoxTree.h"

#include <algorithm>
#include <numeric>

namespace idiophone {

BoxTree::BoxTree(const Mesh& mesh) {
    std::vector<Eigen::AlignedBox3d> boxes(mesh.faceCount());
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        for (int corner = 0; corner < 3; ++corner)
            boxes[face].extend(mesh.vertices.row(mesh.faces(face, corner)).transpose());
    std::vector<std::size_t> faces(boxes.size());
    std::iota(faces.begin(), faces.end(), std::size_t{0});
    allNodes.reserve(2 * faces.size());
    if (!faces.empty())
        build(faces, boxes);
}

/// Appends a node for these faces, then all nodes below it.
void BoxTree::build(std::span<std::size_t> faces, std::span<const Eigen::AlignedBox3d> boxes) {
    Node node;
    Eigen::AlignedBox3d middles;
    for (const std::size_t face : faces) {
        node.box.extend(boxes[face]);
        middles.extend(boxes[face].center());
    }
    node.isLeaf = faces.size() == 1;
    node.face = faces.front();
    const std::size_t own = allNodes.size();
    allNodes.push_back(node);
    if (!node.isLeaf) {
        int axis = 0;
        middles.sizes().maxCoeff(&axis);
        const std::size_t half = faces.size() / 2;
        std::ranges::nth_element(faces, faces.begin() + static_cast<std::ptrdiff_t>(half), {},
                                 [&](std::size_t face) { return boxes[face].center()(axis); });
        build(faces.first(half), boxes);
        build(faces.subspan(half), boxes);
    }
    allNodes[own].after = allNodes.size();
}

std::optional<BoxSearch> BoxTree::touchingFaces(const BoxSearch& maximum) const {
    BoxSearch done;
    // Takes leaves in tree order, so that consecutive searches visit mostly the same nodes.
    for (const auto& own : allNodes) {
        if (!own.isLeaf)
            continue;
        for (std::size_t next = 0; next < allNodes.size();) {
            const auto& node = allNodes[next];
            if (++done.boxes > maximum.boxes)
                return std::nullopt;
            if (!node.box.intersects(own.box)) {
                next = node.after;
                continue;
            }
            // The search meets each pair twice. Count it once.
            if (node.isLeaf && node.face > own.face && ++done.pairs > maximum.pairs)
                return std::nullopt;
            ++next;
        }
    }
    return done;
}

} // namespace idiophone
