#include "Scene/SurfaceShape.h"

#include "Scene/BulletMath.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
#include <BulletCollision/NarrowPhaseCollision/btVoronoiSimplexSolver.h>
#include <algorithm>
#include <limits>

namespace idiophone {
namespace {

// Measured.
constexpr double microsecondsOfSearch = 10, microsecondsOfFace = 3.5;

} // namespace

SurfaceShape::SurfaceShape(btTriangleMesh& triangles, const Mesh& surface)
    : btBvhTriangleMeshShape(&triangles, false, false), mesh(surface), tree(mesh),
      slabs(tree.nodes().size()) {
    const auto nodes = tree.nodes();
    const auto corner = [&](std::size_t node, int k) -> Eigen::Vector3d {
        return corners(nodes[node].face).row(k);
    };
    // From the leaves to the root, because a node's descendants follow it.
    for (std::size_t node = nodes.size(); node-- > 0;) {
        auto& normal = slabs[node].normal;
        if (nodes[node].isLeaf)
            normal = (corner(node, 1) - corner(node, 0)).cross(corner(node, 2) - corner(node, 0));
        else
            normal = slabs[node + 1].normal + slabs[nodes[node + 1].after].normal;
    }
    for (std::size_t node = 0; node < nodes.size(); ++node) {
        auto& slab = slabs[node];
        if (!(slab.normal.norm() > 0))
            continue;
        slab.normal.normalize();
        slab.low = std::numeric_limits<double>::infinity();
        slab.high = -slab.low;
        for (std::size_t leaf = node; leaf < nodes[node].after; ++leaf)
            for (int k = 0; k < 3 && nodes[leaf].isLeaf; ++k) {
                slab.low = std::min(slab.low, slab.normal.dot(corner(leaf, k)));
                slab.high = std::max(slab.high, slab.normal.dot(corner(leaf, k)));
            }
    }
}

/// Returns whether the body is farther from a node than a contact reaches: beside its slab, or in
/// the direction of its box or face. The slab of a face is thin, but endless: the planes of faces
/// around a ball in a bowl pass close to it.
bool SurfaceShape::isApart(std::size_t node) const {
    const auto farthest = [this](const Eigen::Vector3d& direction) {
        const btVector3 own = toBullet(direction) * near->pose.getBasis();
        return direction.dot(toEigen(near->pose(near->shape->localGetSupportingVertex(own)))) +
               near->reachMetres;
    };
    const auto& slab = slabs[node];
    const Eigen::Vector3d centre = toEigen(near->pose.getOrigin());
    const double middle = slab.normal.dot(centre);
    if ((middle > slab.high && -farthest(-slab.normal) > slab.high) ||
        (middle < slab.low && farthest(slab.normal) < slab.low))
        return true;
    const auto& [box, after, face, isLeaf] = tree.nodes()[node];
    const Eigen::Vector3d nearest =
        isLeaf ? nearestOnFace(face, centre) : centre.cwiseMax(box.min()).cwiseMin(box.max());
    const double distance = (nearest - centre).norm();
    if (!(distance > 0))
        return false;
    const Eigen::Vector3d direction = (nearest - centre) / distance;
    const double begins =
        isLeaf ? (corners(face) * direction).minCoeff()
               : direction.dot(box.center()) - direction.cwiseAbs().dot(box.sizes()) / 2;
    return farthest(direction) < begins;
}

Eigen::Vector3d SurfaceShape::nearestOnFace(std::size_t face, const Eigen::Vector3d& point) const {
    const Eigen::Matrix3d all = corners(face);
    const auto corner = [&](int k) { return toBullet(Eigen::Vector3d(all.row(k))); };
    btSubSimplexClosestResult result;
    btVoronoiSimplexSolver().closestPtPointTriangle(toBullet(point), corner(0), corner(1),
                                                    corner(2), result);
    return toEigen(result.m_closestPointOnSimplex);
}

/// Returns the corners in rows.
Eigen::Matrix3d SurfaceShape::corners(std::size_t face) const {
    Eigen::Matrix3d rows;
    for (int k = 0; k < 3; ++k)
        rows.row(k) = mesh.vertices.row(mesh.faces(static_cast<Eigen::Index>(face), k));
    return rows;
}

void SurfaceShape::processAllTriangles(btTriangleCallback* callback,
                                       const btVector3& lowest,
                                       const btVector3& highest) const {
    const Eigen::AlignedBox3d box(toEigen(lowest), toEigen(highest));
    const auto nodes = tree.nodes();
    const bool isForBody = near != nullptr;
    if (isForBody)
        workDone += microsecondsOfSearch;
    for (std::size_t next = 0; next < nodes.size();) {
        const auto& node = nodes[next];
        if (!node.box.intersects(box) || (isForBody && isApart(next))) {
            next = node.after;
            continue;
        }
        ++next;
        if (!node.isLeaf)
            continue;
        if (isForBody)
            workDone += microsecondsOfFace;
        const Eigen::Matrix3d rows = corners(node.face);
        btVector3 all[3];
        for (int k = 0; k < 3; ++k)
            all[k] = toBullet(Eigen::Vector3d(rows.row(k)));
        callback->processTriangle(all, 0, static_cast<int>(node.face));
    }
}

void SurfaceCollision::processCollision(const btCollisionObjectWrapper* first,
                                        const btCollisionObjectWrapper* second,
                                        const btDispatcherInfo& how,
                                        btManifoldResult* result) {
    const bool isSwapped = first->getCollisionShape()->isConcave();
    const auto &fixed = isSwapped ? *first : *second, &body = isSwapped ? *second : *first;
    const auto& surface = static_cast<const SurfaceShape&>(*fixed.getCollisionShape());
    const auto* whole = body.getCollisionObject()->getCollisionShape(); // of which it is a part
    const SurfaceShape::NearBody near{
        .shape = static_cast<const btConvexShape*>(body.getCollisionShape()),
        .pose = fixed.getWorldTransform().inverse() * body.getWorldTransform(),
        .reachMetres =
            surface.getMargin() + whole->getContactBreakingThreshold(gContactBreakingThreshold)};
    surface.searchFor(&near);
    btConvexConcaveCollisionAlgorithm::processCollision(first, second, how, result);
    surface.searchFor(nullptr);
}

} // namespace idiophone
