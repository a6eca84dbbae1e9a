#include "Scene/LowestPoint.h"

#include <algorithm>
#include <limits>
#include <utility>

namespace idiophone {
namespace {

/// Returns a mesh in which every point is a face of its own.
Mesh meshOf(std::span<const Eigen::Vector3d> points) {
    const auto count = static_cast<Eigen::Index>(points.size());
    Mesh mesh{Eigen::MatrixXd(count, 3), Eigen::MatrixXi(count, 3)};
    for (Eigen::Index k = 0; k < count; ++k) {
        mesh.vertices.row(k) = points[static_cast<std::size_t>(k)].transpose();
        mesh.faces.row(k).setConstant(static_cast<int>(k));
    }
    return mesh;
}

} // namespace

LowestPoint::LowestPoint(std::span<const Eigen::Vector3d> points)
    : tree(meshOf(points)), slackMetres(1e-12 * tree.nodes().front().box.sizes().norm()) {}

double LowestPoint::metres(const Eigen::Isometry3d& placed) const {
    const auto nodes = tree.nodes();
    const Eigen::Vector3d up = placed.linear().row(2).transpose();
    const auto bound = [&](std::size_t node) {
        const auto& box = nodes[node].box;
        return (placed * box.center()).z() - up.cwiseAbs().dot(box.sizes()) / 2;
    };
    double lowest = std::numeric_limits<double>::infinity();
    const auto search = [&](const auto& self, std::size_t node) -> void {
        if (nodes[node].isLeaf) {
            lowest = std::min(lowest, (placed * nodes[node].box.min()).z());
            return;
        }
        std::pair first(bound(node + 1), node + 1), second(0.0, nodes[node + 1].after);
        second.first = bound(second.second);
        if (second.first < first.first)
            std::swap(first, second);
        for (const auto& [metres, half] : {first, second})
            if (metres < lowest + slackMetres)
                self(self, half);
    };
    search(search, 0);
    return lowest;
}

} // namespace idiophone
