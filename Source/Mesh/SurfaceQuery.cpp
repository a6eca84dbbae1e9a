// SPDX-License-Identifier: Apache-2.0
#include "Mesh/SurfaceQuery.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <igl/AABB.h>
#include <igl/point_simplex_squared_distance.h>
#include <limits>
#include <utility>
#include <vector>

namespace idiophone {

struct SurfaceQuery::Tree : igl::AABB<Eigen::MatrixXd, 3> {};

namespace {

struct Triangle {
    Eigen::Vector3d a, u, v; ///< a corner, and the edges from it to the other two

    Triangle(const Mesh& mesh, int face)
        : a(mesh.vertices.row(mesh.faces(face, 0))),
          u(mesh.vertices.row(mesh.faces(face, 1)).transpose() - a),
          v(mesh.vertices.row(mesh.faces(face, 2)).transpose() - a) {}

    Eigen::Vector3d normal() const {
        const Eigen::Vector3d n = u.cross(v);
        const double length = n.norm();
        return length > 0 ? Eigen::Vector3d(n / length) : Eigen::Vector3d::UnitZ();
    }

    /// Returns the barycentric weights of a point on the triangle.
    Eigen::Vector3d barycentric(const Eigen::Vector3d& point) const {
        const Eigen::Vector3d w = point - a, n = u.cross(v);
        const double n2 = n.squaredNorm();
        double s = 0, t = 0;
        if (n2 > 0) {
            s = w.cross(v).dot(n) / n2;
            t = u.cross(w).dot(n) / n2;
        } else if (const auto& longer = u.squaredNorm() > v.squaredNorm() ? u : v;
                   longer.squaredNorm() > 0) { // a degenerate face is a segment
            (&longer == &u ? s : t) = w.dot(longer) / longer.squaredNorm();
        }
        Eigen::Vector3d weights = Eigen::Vector3d(1 - s - t, s, t).cwiseMax(0);
        return weights / weights.sum();
    }

    /// Returns the distance along the ray in lengths of `direction` (Möller & Trumbore 1997).
    std::optional<double> hit(const Eigen::Vector3d& origin,
                              const Eigen::Vector3d& direction) const {
        const Eigen::Vector3d p = direction.cross(v);
        const double determinant = u.dot(p);
        if (std::abs(determinant) <= 1e-14 * u.norm() * v.norm() * direction.norm())
            return std::nullopt;
        // A small tolerance, so that a ray along a shared edge hits one of the two faces.
        constexpr double slack = 1e-12;
        const Eigen::Vector3d w = origin - a, q = w.cross(u);
        const double s = w.dot(p) / determinant, t = direction.dot(q) / determinant;
        if (s < -slack || t < -slack || s + t > 1 + slack)
            return std::nullopt;
        const double distance = v.dot(q) / determinant;
        return distance >= 0 ? std::optional(distance) : std::nullopt;
    }
};

/// Returns the distance at which the ray enters the box, in lengths of the direction, or infinity.
double entry(const Eigen::AlignedBox3d& box,
             const Eigen::Vector3d& origin,
             const Eigen::Vector3d& direction) {
    double near = 0, far = std::numeric_limits<double>::infinity();
    for (int axis = 0; axis < 3; ++axis) {
        if (direction(axis) == 0) {
            if (origin(axis) < box.min()(axis) || origin(axis) > box.max()(axis))
                return std::numeric_limits<double>::infinity();
            continue;
        }
        const double t0 = (box.min()(axis) - origin(axis)) / direction(axis);
        const double t1 = (box.max()(axis) - origin(axis)) / direction(axis);
        near = std::max(near, std::min(t0, t1));
        far = std::min(far, std::max(t0, t1));
    }
    const double slack = 1e-12 * std::abs(far); // rounding must not make flat boxes empty
    return near <= far + slack ? near : std::numeric_limits<double>::infinity();
}

SurfacePoint surfacePoint(const Mesh& mesh, int face, const Eigen::Vector3d& point) {
    const Triangle triangle(mesh, face);
    return {.face = face,
            .barycentric = triangle.barycentric(point),
            .pointMetres = point,
            .normal = triangle.normal(),
            .distanceMetres = 0};
}

} // namespace

SurfaceQuery::SurfaceQuery(Mesh mesh) : mesh_(std::move(mesh)), tree_(std::make_unique<Tree>()) {
    tree_->init(mesh_.vertices, mesh_.faces);
}
SurfaceQuery::~SurfaceQuery() = default;
SurfaceQuery::SurfaceQuery(SurfaceQuery&&) noexcept = default;
SurfaceQuery& SurfaceQuery::operator=(SurfaceQuery&&) noexcept = default;

SurfacePoint SurfaceQuery::nearestPoint(const Eigen::Vector3d& point) const {
    std::int64_t boxBudget = boxesForPoint;
    return nearestPoint(point, boxBudget);
}

// Searches as libigl does, in its order and with its triangle distance, but with a box limit.
SurfacePoint SurfaceQuery::nearestPoint(const Eigen::Vector3d& point,
                                        std::int64_t& boxBudget) const {
    using Node = igl::AABB<Eigen::MatrixXd, 3>;
    const Eigen::RowVector3d from = point.transpose();
    double best = std::numeric_limits<double>::infinity();
    int bestFace = -1;
    Eigen::RowVector3d nearest;
    const auto search = [&](const auto& self, const Node& node) -> void {
        if (boxBudget <= 0)
            return;
        --boxBudget;
        if (node.m_primitive >= 0) {
            double squared = 0;
            Eigen::RowVector3d candidate;
            igl::point_simplex_squared_distance<3>(from, mesh_.vertices, mesh_.faces,
                                                   node.m_primitive, squared, candidate);
            if (squared < best) {
                best = squared;
                bestFace = node.m_primitive;
                nearest = candidate;
            }
            return;
        }
        const Node *first = node.m_left, *second = node.m_right;
        if (!first->m_box.contains(point) &&
            (second->m_box.contains(point) || !(first->m_box.squaredExteriorDistance(point) <
                                                second->m_box.squaredExteriorDistance(point))))
            std::swap(first, second);
        for (const auto* half : {first, second})
            if (half->m_box.squaredExteriorDistance(point) < best)
                self(self, *half);
    };
    search(search, *tree_);
    if (bestFace < 0) { // no distance was finite, or no box was left
        auto some = surfacePoint(mesh_, 0, mesh_.vertices.row(mesh_.faces(0, 0)).transpose());
        some.distanceMetres = std::numeric_limits<double>::infinity();
        return some;
    }
    auto result = surfacePoint(mesh_, bestFace, nearest.transpose());
    result.distanceMetres = std::sqrt(best);
    return result;
}

template <typename Visit>
bool SurfaceQuery::visitAlong(const Eigen::Vector3d& origin,
                              const Eigen::Vector3d& direction,
                              const double& reach,
                              std::int64_t& boxBudget,
                              const Visit& visit) const {
    // libigl's ray test works in float and treats triangles under 1e-6 m² as parallel to every ray.
    // Use its tree with our own test.
    const igl::AABB<Eigen::MatrixXd, 3>* root = tree_.get();
    std::vector pending{root};
    while (!pending.empty()) {
        const auto* node = pending.back();
        pending.pop_back();
        if (boxBudget <= 0)
            return false;
        --boxBudget;
        if (entry(node->m_box, origin, direction) >= reach)
            continue;
        if (node->m_primitive >= 0) {
            if (const auto distance = Triangle(mesh_, node->m_primitive).hit(origin, direction))
                visit(node->m_primitive, *distance);
            continue;
        }
        pending.push_back(node->m_left);
        pending.push_back(node->m_right);
    }
    return true;
}

std::optional<SurfacePoint> SurfaceQuery::firstHit(const Eigen::Vector3d& origin,
                                                   const Eigen::Vector3d& direction) const {
    std::int64_t boxBudget = boxesForRay;
    return firstHit(origin, direction, boxBudget);
}

std::optional<SurfacePoint> SurfaceQuery::firstHit(const Eigen::Vector3d& origin,
                                                   const Eigen::Vector3d& direction,
                                                   std::int64_t& boxBudget) const {
    double best = std::numeric_limits<double>::infinity();
    int bestFace = -1;
    visitAlong(origin, direction, best, boxBudget, [&](int face, double distance) {
        if (distance < best) {
            best = distance;
            bestFace = face;
        }
    });
    if (bestFace < 0)
        return std::nullopt;
    auto result = surfacePoint(mesh_, bestFace, origin + best * direction);
    result.distanceMetres = best * direction.norm();
    return result;
}

std::optional<std::vector<double>> SurfaceQuery::passages(const Eigen::Vector3d& origin,
                                                          const Eigen::Vector3d& direction,
                                                          std::int64_t& boxBudget) const {
    constexpr double everywhere = std::numeric_limits<double>::infinity();
    std::vector<double> distances;
    if (!visitAlong(origin, direction, everywhere, boxBudget,
                    [&](int, double distance) { distances.push_back(distance); }))
        return std::nullopt;
    std::ranges::sort(distances);
    return distances;
}

} // namespace idiophone
