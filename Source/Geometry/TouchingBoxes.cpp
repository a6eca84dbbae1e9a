#include "Geometry/TouchingBoxes.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <numeric>
#include <span>
#include <vector>

namespace idiophone {
namespace {

/// Halves the faces across the axis along which their middles lie farthest apart. The trees of
/// libigl, CGAL and Eigen go by the boxes' own lengths or by each axis in turn, and so tell long
/// slivers beside each other apart late or not at all.
class Tree {
public:
    explicit Tree(const Mesh& mesh) : order_(static_cast<std::size_t>(mesh.faceCount())) {
        faces_.resize(order_.size());
        for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
            for (int corner = 0; corner < 3; ++corner)
                faces_[static_cast<std::size_t>(face)].extend(
                    mesh.vertices.row(mesh.faces(face, corner)).transpose());
        std::iota(order_.begin(), order_.end(), std::size_t{0});
        nodes_.reserve(2 * order_.size());
        if (!order_.empty())
            build(order_);
    }

    /// Of each face in the tree's order, so that each looks at much the same as the one before.
    std::optional<BoxSearch> search(const BoxSearch& most) const {
        BoxSearch done;
        for (const std::size_t face : order_)
            for (std::size_t next = 0; next < nodes_.size();) {
                const auto& node = nodes_[next];
                if (++done.boxes > most.boxes)
                    return std::nullopt;
                if (!node.box.intersects(faces_[face])) {
                    next = node.after;
                    continue;
                }
                // Each pair is met from both sides, and counted from one.
                if (node.isLeaf && node.face > face && ++done.pairs > most.pairs)
                    return std::nullopt;
                ++next;
            }
        return done;
    }

private:
    struct Node {
        Eigen::AlignedBox3d box;
        std::size_t after = 0; ///< the first node that is not below this one
        std::size_t face = 0;  ///< of a leaf
        bool isLeaf = false;
    };

    /// A node, and behind it all that is below it.
    void build(std::span<std::size_t> faces) {
        Node node;
        Eigen::AlignedBox3d middles;
        for (const std::size_t face : faces) {
            node.box.extend(faces_[face]);
            middles.extend(faces_[face].center());
        }
        node.isLeaf = faces.size() == 1;
        node.face = faces.front();
        const std::size_t own = nodes_.size();
        nodes_.push_back(node);
        if (!node.isLeaf) {
            int axis = 0;
            middles.sizes().maxCoeff(&axis);
            const std::size_t half = faces.size() / 2;
            std::ranges::nth_element(faces, faces.begin() + static_cast<std::ptrdiff_t>(half), {},
                                     [&](std::size_t face) { return faces_[face].center()(axis); });
            build(faces.first(half));
            build(faces.subspan(half));
        }
        nodes_[own].after = nodes_.size();
    }

    std::vector<Eigen::AlignedBox3d> faces_;
    std::vector<std::size_t> order_;
    std::vector<Node> nodes_;
};

} // namespace

std::optional<BoxSearch> touchingBoxes(const Mesh& mesh, const BoxSearch& most) {
    return Tree(mesh).search(most);
}

} // namespace idiophone
