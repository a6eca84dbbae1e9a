#include "Geometry/PointCarrier.h"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>
#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>
#include <vector>

namespace idiophone {
namespace {

using Eigen::Index;
using Eigen::MatrixXd;
using Eigen::Vector3d;

constexpr double smallDiscMetres = 0.01;
constexpr int spokes = 24;
constexpr double stripShare = 0.1;
// Points count as a line if their extent across the line is at most this fraction of the extent
// along it.
constexpr double lineShare = 1e-3;
// Triangles smaller than this fraction of the squared extent are dropped as slivers.
constexpr double sliverShare = 1e-9;

/// The principal axes of a set of points around its mean, in order of decreasing extent.
struct Frame {
    Vector3d mean;
    Eigen::Matrix3d axes;
    Vector3d extents; ///< root mean squares

    explicit Frame(std::span<const Vector3d> points) {
        MatrixXd offsets(points.size(), 3);
        for (std::size_t i = 0; i < points.size(); ++i)
            offsets.row(i) = points[i].transpose();
        mean = offsets.colwise().mean().transpose();
        offsets.rowwise() -= mean.transpose();
        const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
            offsets.transpose() * offsets / static_cast<double>(points.size()));
        axes = solver.eigenvectors().rowwise().reverse();
        extents = solver.eigenvalues().reverse().cwiseMax(0).cwiseSqrt();
    }

    bool isLine() const { return extents(1) <= lineShare * extents(0); }
};

/// Returns the unit normal of a line that points up, or along +x if the line is upright.
Vector3d normalOfLine(const Vector3d& along) {
    const Vector3d up = std::abs(along.z()) < 0.9 ? Vector3d::UnitZ() : Vector3d::UnitX();
    return (up - along * along.dot(up)).normalized();
}

/// Returns one row of weights per vertex: 1 for its point, 0 for the others.
MatrixXd chosen(const std::vector<std::size_t>& pointOfVertex, std::size_t points) {
    MatrixXd weights = MatrixXd::Zero(pointOfVertex.size(), points);
    for (std::size_t i = 0; i < pointOfVertex.size(); ++i)
        weights(i, pointOfVertex[i]) = 1;
    return weights;
}

PointCarrier strip(std::span<const Vector3d> points, const Frame& frame) {
    const Vector3d along = frame.axes.col(0);
    const Vector3d up = normalOfLine(along);
    std::vector<std::pair<double, std::size_t>> order;
    for (std::size_t i = 0; i < points.size(); ++i)
        order.emplace_back(along.dot(points[i]), i);
    std::ranges::sort(order);
    const Vector3d aside =
        up.cross(along) * (stripShare * (order.back().first - order.front().first));
    PointCarrier carrier;
    const auto count = static_cast<int>(points.size());
    carrier.mesh.vertices.resize(3 * count, 3);
    carrier.mesh.faces.resize(4 * (count - 1), 3);
    std::vector<std::size_t> pointOfVertex;
    for (int i = 0; i < count; ++i) {
        const std::size_t point = order[i].second;
        for (int side = -1; side <= 1; ++side) {
            carrier.mesh.vertices.row(3 * i + side + 1) =
                (points[point] + side * aside).transpose();
            pointOfVertex.push_back(point);
        }
        for (int half = 0; half < 2 && i + 1 < count; ++half) {
            const int a = 3 * i + half, b = a + 3;
            carrier.mesh.faces.row(4 * i + 2 * half) << a, b, b + 1;
            carrier.mesh.faces.row(4 * i + 2 * half + 1) << a, b + 1, a + 1;
        }
    }
    carrier.weights = chosen(pointOfVertex, points.size());
    return carrier;
}

PointCarrier triangulation(std::span<const Vector3d> points, const Frame& frame) {
    using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
    using Vertex = CGAL::Triangulation_vertex_base_with_info_2<int, Kernel>;
    using Structure = CGAL::Triangulation_data_structure_2<Vertex>;
    Eigen::Matrix3d axes = frame.axes;
    // Face upward, or towards +x if the surface is upright.
    if (Vector3d(1e-3, 1e-6, 1).dot(axes.col(2)) < 0)
        axes.col(2) *= -1;
    axes.col(1) = axes.col(2).cross(axes.col(0));
    std::vector<std::pair<Kernel::Point_2, int>> flat;
    PointCarrier carrier;
    carrier.mesh.vertices.resize(points.size(), 3);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const Vector3d place = axes.transpose() * (points[i] - frame.mean);
        flat.emplace_back(Kernel::Point_2(place.x(), place.y()), static_cast<int>(i));
        carrier.mesh.vertices.row(i) = points[i].transpose();
    }
    const CGAL::Delaunay_triangulation_2<Kernel, Structure> delaunay(flat.begin(), flat.end());
    Eigen::MatrixXi faces(delaunay.number_of_faces(), 3);
    Index count = 0;
    for (auto face = delaunay.finite_faces_begin(); face != delaunay.finite_faces_end(); ++face) {
        // Points on one edge of the outline are collinear except for rounding.
        if (delaunay.triangle(face).area() > sliverShare * frame.extents(0) * frame.extents(0))
            faces.row(count++) << face->vertex(0)->info(), face->vertex(1)->info(),
                face->vertex(2)->info();
    }
    carrier.mesh.faces = faces.topRows(count);
    carrier.weights = MatrixXd::Identity(points.size(), points.size());
    return carrier;
}

PointCarrier smallDisc(const Vector3d& centre) {
    const double radius = 0;
    PointCarrier carrier = discOfRadii({&radius, 1});
    carrier.mesh.vertices.rowwise() += centre.transpose();
    return carrier;
}

} // namespace

PointCarrier carrierThrough(std::span<const Vector3d> points) {
    if (points.size() == 1)
        return smallDisc(points.front());
    const Frame frame(points);
    return frame.isLine() ? strip(points, frame) : triangulation(points, frame);
}

PointCarrier discOfRadii(std::span<const double> radiiMetres) {
    std::vector<std::pair<double, std::size_t>> rings;
    for (std::size_t i = 0; i < radiiMetres.size(); ++i)
        if (radiiMetres[i] > 0)
            rings.emplace_back(radiiMetres[i], i);
    if (rings.empty())
        rings.emplace_back(smallDiscMetres, 0);
    PointCarrier carrier;
    const auto count = static_cast<int>(rings.size());
    carrier.mesh.vertices = MatrixXd::Zero(1 + spokes * count, 3);
    carrier.mesh.faces.resize(spokes * (2 * count - 1), 3);
    std::vector<std::size_t> pointOfVertex{0};
    int face = 0;
    for (int ring = 0; ring < count; ++ring)
        for (int spoke = 0; spoke < spokes; ++spoke) {
            const auto [radius, point] = rings[ring];
            const double angle = 2 * std::numbers::pi * spoke / spokes;
            const int outer = 1 + ring * spokes + spoke;
            const int outerNext = 1 + ring * spokes + (spoke + 1) % spokes;
            carrier.mesh.vertices.row(outer) << radius * std::cos(angle), radius * std::sin(angle),
                0;
            pointOfVertex.push_back(point);
            if (ring == 0) {
                carrier.mesh.faces.row(face++) << 0, outer, outerNext;
                continue;
            }
            carrier.mesh.faces.row(face++) << outer - spokes, outer, outerNext;
            carrier.mesh.faces.row(face++) << outer - spokes, outerNext, outerNext - spokes;
        }
    carrier.weights = chosen(pointOfVertex, radiiMetres.size());
    return carrier;
}

PointCarrier carriedBy(Mesh mesh, std::span<const Vector3d> points) {
    const double nearest = 1e-9 * std::max(boundingDiagonalMetres(mesh), 1e-9);
    const auto count = static_cast<Index>(points.size());
    MatrixXd weights(mesh.vertexCount(), count);
    for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        for (Index point = 0; point < count; ++point) {
            const double distance =
                std::max((mesh.vertices.row(vertex).transpose() - points[point]).norm(), nearest);
            weights(vertex, point) = 1 / (distance * distance);
        }
        weights.row(vertex) /= weights.row(vertex).sum();
    }
    return {.mesh = std::move(mesh), .weights = std::move(weights)};
}

PointCarrier carriedBy(Mesh mesh, std::span<const double> radiiMetres) {
    MatrixXd weights = MatrixXd::Zero(mesh.vertexCount(), radiiMetres.size());
    for (Index vertex = 0; vertex < mesh.vertexCount(); ++vertex) {
        const double radius = std::hypot(mesh.vertices(vertex, 0), mesh.vertices(vertex, 1));
        const auto above = std::ranges::lower_bound(radiiMetres, radius);
        const auto upper = std::min(above - radiiMetres.begin(),
                                    static_cast<std::ptrdiff_t>(radiiMetres.size()) - 1);
        const auto lower =
            std::max<std::ptrdiff_t>(above == radiiMetres.end() ? upper : upper - 1, 0);
        const double span = radiiMetres[upper] - radiiMetres[lower];
        const double share = span > 0 ? (radius - radiiMetres[lower]) / span : 0;
        weights(vertex, lower) += 1 - share;
        weights(vertex, upper) += share;
    }
    return {.mesh = std::move(mesh), .weights = std::move(weights)};
}

} // namespace idiophone
