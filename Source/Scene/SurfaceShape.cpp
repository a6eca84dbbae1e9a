#include "Scene/SurfaceShape.h"

#include "Scene/BulletMath.h"

#include <BulletCollision/CollisionDispatch/btCollisionObjectWrapper.h>
#include <BulletCollision/CollisionDispatch/btManifoldResult.h>
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
        const auto face = static_cast<Eigen::Index>(nodes[node].face);
        return mesh.vertices.row(mesh.faces(face, k));
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
/// the direction of its box.
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
    const auto& box = tree.nodes()[node].box;
    const Eigen::Vector3d towards = centre.cwiseMax(box.min()).cwiseMin(box.max()) - centre;
    const double distance = towards.norm();
    if (!(distance > 0))
        return false;
    const Eigen::Vector3d direction = towards / distance;
    return farthest(direction) <
           direction.dot(box.center()) - direction.cwiseAbs().dot(box.sizes()) / 2;
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
        const auto face = static_cast<Eigen::Index>(node.face);
        btVector3 corners[3];
        for (int k = 0; k < 3; ++k)
            corners[k] = toBullet(Eigen::Vector3d(mesh.vertices.row(mesh.faces(face, k))));
        callback->processTriangle(corners, 0, static_cast<int>(face));
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
