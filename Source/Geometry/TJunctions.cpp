#include "Geometry/TJunctions.h"

#include "Geometry/EdgeSplit.h"
#include "Geometry/VertexTree.h"
#include "Mesh/FaceSides.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <limits>
#include <unordered_map>
#include <vector>

namespace idiophone {
namespace {

/// Returns the sides along which no other face has a side.
std::vector<FaceSide> boundaryEdgesOf(const Mesh& mesh) {
    const auto sides = sortedFaceSides(mesh);
    std::vector<FaceSide> result;
    for (std::size_t i = 0, end = 0; i < sides.size(); i = end) {
        while (end < sides.size() && sides[end].isAlong(sides[i]))
            ++end;
        if (end - i == 1)
            result.push_back(sides[i]);
    }
    return result;
}

/// A query region for CGAL's tree: the points within a distance of a segment.
class Tube {
public:
    using D = VertexTreeTraits::Dimension;
    Tube(const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius)
        : from_(from), direction_(to - from), radius_(radius) {}

    bool contains(const NumberedPoint& candidate) const {
        const Eigen::Vector3d point(candidate.first.x(), candidate.first.y(), candidate.first.z());
        const double along =
            std::clamp((point - from_).dot(direction_) / direction_.squaredNorm(), 0.0, 1.0);
        return (from_ + along * direction_ - point).squaredNorm() <= radius_ * radius_;
    }

    bool inner_range_intersects(const CGAL::Kd_tree_rectangle<double, D>& box) const {
        double enter = 0, leave = 1;
        for (int axis = 0; axis < 3; ++axis) {
            const double low = box.min_coord(axis) - radius_ - from_(axis);
            const double high = box.max_coord(axis) + radius_ - from_(axis);
            if (direction_(axis) == 0) {
                if (low > 0 || high < 0)
                    return false;
                continue;
            }
            const double a = low / direction_(axis), b = high / direction_(axis);
            enter = std::max(enter, std::min(a, b));
            leave = std::min(leave, std::max(a, b));
        }
        // Rounding must not exclude a box that the segment grazes: `contains` decides.
        return enter <= leave + 1e-9;
    }
    bool outer_range_contains(const CGAL::Kd_tree_rectangle<double, D>&) const { return false; }

private:
    Eigen::Vector3d from_, direction_;
    double radius_;
};

void plantBoundaryVertices(VertexTree& tree, const Mesh& mesh, const std::vector<FaceSide>& edges) {
    std::vector<char> isBoundary(mesh.vertexCount(), 0);
    for (const auto& edge : edges)
        for (const int end : {0, 1})
            isBoundary[mesh.faces(edge.face, (edge.corner + end) % 3)] = 1;
    for (int vertex = 0; vertex < mesh.vertexCount(); ++vertex)
        if (isBoundary[vertex])
            tree.insert(numberedPoint(mesh.vertices, vertex));
    tree.build();
}

/// Returns the vertices on the edge, from its start to its end.
std::vector<int>
verticesOn(const Mesh& mesh, const VertexTree& tree, const FaceSide& edge, double toleranceMetres) {
    const int a = mesh.faces(edge.face, edge.corner),
              b = mesh.faces(edge.face, (edge.corner + 1) % 3),
              apex = mesh.faces(edge.face, (edge.corner + 2) % 3);
    const Eigen::Vector3d from = mesh.vertices.row(a), to = mesh.vertices.row(b);
    const double length = (to - from).norm();
    if (length <= 2 * toleranceMetres)
        return {};
    std::vector<NumberedPoint> found;
    tree.search(std::back_inserter(found), Tube(from, to, toleranceMetres));
    std::vector<std::pair<double, int>> inside; // position along the edge in metres, vertex
    for (const auto& [point, vertex] : found) {
        const double along =
            (Eigen::Vector3d(point.x(), point.y(), point.z()) - from).dot((to - from) / length);
        if (vertex != a && vertex != b && vertex != apex && along > toleranceMetres &&
            along < length - toleranceMetres)
            inside.emplace_back(along, vertex);
    }
    std::ranges::sort(inside);
    std::vector<int> result;
    double last = 0;
    for (const auto& [along, vertex] : inside)
        if (along - last > toleranceMetres) { // skip vertices too close together
            result.push_back(vertex);
            last = along;
        }
    return result;
}

} // namespace

int splitTJunctions(Mesh& mesh, double toleranceMetres) {
    const auto edges = boundaryEdgesOf(mesh);
    if (edges.empty() || edges.size() > maximumOpenEdges)
        return 0;
    VertexTree tree;
    plantBoundaryVertices(tree, mesh, edges);
    std::unordered_map<int, EdgeInsertions> insertions;
    const std::size_t maximum = 2 * edges.size() + 1000;
    std::size_t count = 0;
    for (const auto& edge : edges) {
        if (count > maximum)
            break;
        if (auto vertices = verticesOn(mesh, tree, edge, toleranceMetres); !vertices.empty()) {
            count += vertices.size();
            insertions[edge.face][edge.corner] = std::move(vertices);
        }
    }
    splitFaces(mesh, insertions);
    return static_cast<int>(count);
}

} // namespace idiophone
