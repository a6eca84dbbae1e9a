// A surface's collision shape: it offers Bullet only the faces that a body may touch.
#pragma once

#include "Geometry/BoxTree.h"

#include <BulletCollision/CollisionDispatch/btConvexConcaveCollisionAlgorithm.h>
#include <btBulletDynamicsCommon.h>
#include <vector>

namespace idiophone {

/// Keeps the faces in a BoxTree. Each node also has a slab, between two parallel planes, in which
/// all its faces lie. A smooth surface's slabs are thin, so that a body beside it meets few faces,
/// while a box around the body contains hundreds. Bullet's own trees have no slabs, widen boxes to
/// 2 mm, and split uneven surfaces badly.
class SurfaceShape final : public btBvhTriangleMeshShape {
public:
    /// A convex body near the surface.
    struct NearBody {
        const btConvexShape* shape;
        btTransform pose;   ///< in the surface's coordinates
        double reachMetres; ///< the maximum distance of a contact
    };

    /// Expects valid indices and finite coordinates. `triangles` are those of the mesh, and must
    /// outlive the shape.
    SurfaceShape(btTriangleMesh& triangles, const Mesh& mesh);

    /// Sets the body for which Bullet searches, or null: then all faces in the box count.
    void searchFor(const NearBody* body) const { near = body; }
    void processAllTriangles(btTriangleCallback* callback,
                             const btVector3& lowest,
                             const btVector3& highest) const override;

    /// Returns the time of all searches for bodies in microseconds, estimated from the faces found.
    double work() const { return workDone; }

private:
    struct Slab {
        Eigen::Vector3d normal = Eigen::Vector3d::Zero(); ///< zero if the faces have no direction
        double low = 0, high = 0;
    };

    bool isApart(std::size_t node) const;
    Eigen::Vector3d nearestOnFace(std::size_t face, const Eigen::Vector3d& point) const;
    Eigen::Matrix3d corners(std::size_t face) const;

    Mesh mesh;
    BoxTree tree;
    std::vector<Slab> slabs; ///< by node
    mutable const NearBody* near = nullptr;
    mutable double workDone = 0;
};

/// Collides a convex body with a SurfaceShape as Bullet does, with the faces that it may touch.
class SurfaceCollision final : public btConvexConcaveCollisionAlgorithm {
public:
    using btConvexConcaveCollisionAlgorithm::btConvexConcaveCollisionAlgorithm;

    void processCollision(const btCollisionObjectWrapper* first,
                          const btCollisionObjectWrapper* second,
                          const btDispatcherInfo& how,
                          btManifoldResult* result) override;
};

} // namespace idiophone
