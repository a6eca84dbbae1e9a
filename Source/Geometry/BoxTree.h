// A tree of boxes around the faces of a mesh, and how near each other they tell that the faces are.
#pragma once

#include "Geometry/Mesh.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace idiophone {

/// What it takes to look for each face's neighbours in the tree.
struct BoxSearch {
    std::size_t pairs = 0; ///< of faces whose bounding boxes overlap or touch
    std::size_t boxes = 0; ///< looked at; sound meshes have under a hundred a face
};

/// Halves the faces across the axis along which their middles lie farthest apart. The trees of
/// libigl, CGAL, Eigen and Bullet go by the boxes' own lengths, by each axis in turn or by the mean
/// of their middles, and so tell some faces apart late or not at all.
class BoxTree {
public:
    /// What is below a node stands right behind it.
    struct Node {
        Eigen::AlignedBox3d box;
        std::size_t after = 0; ///< the first node that is not below this one
        std::size_t face = 0;  ///< of a leaf
        bool isLeaf = false;
    };

    /// Takes n log n for n faces. Indices are valid, coordinates finite.
    explicit BoxTree(const Mesh& mesh);

    /// The root is the first, and there is none of a mesh without faces.
    std::span<const Node> nodes() const { return allNodes; }

    /// Nothing where either number is more than that of `most`. Takes some 10 ns a box that is
    /// looked at.
    std::optional<BoxSearch> touchingFaces(const BoxSearch& most) const;

private:
    void build(std::span<std::size_t> faces, std::span<const Eigen::AlignedBox3d> boxes);

    std::vector<Node> allNodes;
};

} // namespace idiophone
