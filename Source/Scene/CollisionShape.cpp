#include "Scene/CollisionShape.h"

#include "Mesh/ObjectMesh.h"
#include "Scene/BulletMath.h"
#include "Scene/RingShape.h"
#include "Scene/SurfaceShape.h"

#include <BulletCollision/CollisionDispatch/btInternalEdgeUtility.h>
#include <LinearMath/btConvexHullComputer.h>
#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double roundestSection = 1.25; // maximum ratio of a ring's width and height
constexpr int sectors = 20;              // of a ring
constexpr int maximumHullVertices = 72;
constexpr double marginShare = 0.01; // of a shape's smallest size
constexpr double maximumMarginMetres = 5e-4;
constexpr double maximumMarginOfDepth = 0.1; // from the middle to the nearest face

/// Returns all corners if they are few. Otherwise returns the extreme corners in directions along a
/// spiral on the sphere.
std::vector<btVector3> fewer(const btAlignedObjectArray<btVector3>& corners) {
    std::vector<btVector3> kept;
    if (corners.size() <= maximumHullVertices) {
        for (int k = 0; k < corners.size(); ++k)
            kept.push_back(corners[k]);
        return kept;
    }
    const double turn = std::numbers::pi * (3 - std::sqrt(5.0));
    for (int direction = 0; direction < maximumHullVertices; ++direction) {
        const double z = 1 - (2 * direction + 1.0) / maximumHullVertices;
        const double radius = std::sqrt(1 - z * z);
        const btVector3 way(radius * std::cos(turn * direction),
                            radius * std::sin(turn * direction), z);
        int farthest = 0;
        for (int k = 1; k < corners.size(); ++k)
            if (corners[k].dot(way) > corners[farthest].dot(way))
                farthest = k;
        if (std::ranges::find(kept, corners[farthest]) == kept.end())
            kept.push_back(corners[farthest]);
    }
    return kept;
}

btTransform bodyFromMesh(const RigidBodyModel& model) {
    return toBullet(Eigen::Isometry3d(model.meshFromBody.inverse()));
}

double angleOf(const Eigen::RowVector3d& point) {
    const double angle = std::atan2(point.y(), point.x()) / (2 * std::numbers::pi);
    return angle < 0 ? angle + 1 : angle;
}

} // namespace

template <class Shape, class... Arguments>
Shape* CollisionShape::own(Arguments&&... arguments) {
    auto made = std::make_unique<Shape>(std::forward<Arguments>(arguments)...);
    auto* shape = made.get();
    shapes.push_back(std::move(made));
    return shape;
}

CollisionShape::CollisionShape(const RigidBodyModel& model) {
    switch (model.form) {
    case BodyForm::hull:
        root = hull(outerVertices(model));
        break;
    case BodyForm::ring:
        root = ring(model);
        break;
    case BodyForm::sphere:
    case BodyForm::cylinder:
        root = round(model);
        break;
    case BodyForm::surface:
    case BodyForm::mesh:
        root = meshOf(model);
        break;
    case BodyForm::ground:
        root = ground(model);
        break;
    }
    if (!model.isFixed && model.form != BodyForm::ring) {
        auto* placed = own<btCompoundShape>();
        placed->addChildShape(bodyFromMesh(model), root);
        root = placed;
    }
}

/// Makes a hull that is as large as the points once Bullet has added its margin.
btCollisionShape* CollisionShape::hull(const std::vector<Eigen::Vector3d>& points) {
    btConvexHullComputer computer;
    const auto compute = [&](double margin) {
        return computer.compute(points.front().data(), sizeof(Eigen::Vector3d),
                                static_cast<int>(points.size()), margin, maximumMarginOfDepth);
    };
    // A body that lies askew in its box is thinner than the box. compute() then reduces the margin.
    double margin = compute(
        std::min(maximumMarginMetres, marginShare * boundingBox(points).sizes().minCoeff()));
    if (computer.vertices.size() == 0) // too thin for any margin
        margin = compute(0);
    auto* shape = own<btConvexHullShape>();
    for (const auto& corner : fewer(computer.vertices))
        shape->addPoint(corner, false);
    shape->recalcLocalAabb();
    shape->setMargin(margin);
    constexpr int minimumFaces = 4; // with fewer faces Bullet reads beyond its list
    if (computer.vertices.size() <= maximumHullVertices && computer.faces.size() >= minimumFaces)
        shape->initializePolyhedralFeatures(); // lets whole faces collide
    return shape;
}

/// A ring with a round section costs a fraction of hulls.
btCollisionShape* CollisionShape::ring(const RigidBodyModel& model) {
    const auto outer = outerVertices(model);
    Eigen::AlignedBox2d section; // x: distance from the axis, y: height
    for (const auto& vertex : outer)
        section.extend(Eigen::Vector2d(vertex.head<2>().norm(), vertex.z()));
    const Eigen::Vector2d half = section.sizes() / 2, middle = section.center();
    if (half.maxCoeff() > roundestSection * half.minCoeff())
        return sectorHulls(model, outer);
    auto pose = bodyFromMesh(model);
    pose.setOrigin(pose(btVector3(0, 0, middle.y())));
    return own<RingShape>(
        RoundRing{.pose = pose, .radius = middle.x(), .sectionRadius = half.mean()});
}

btCollisionShape* CollisionShape::sectorHulls(const RigidBodyModel& model,
                                              const std::vector<Eigen::Vector3d>& outer) {
    const Mesh mesh = objectMesh(*model.object);
    const std::size_t sides = outer.size() / static_cast<std::size_t>(mesh.vertexCount());
    std::vector<std::vector<Eigen::Vector3d>> points(sectors);
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face) {
        Eigen::RowVector3d middle = Eigen::RowVector3d::Zero();
        for (int corner = 0; corner < 3; ++corner)
            middle += mesh.vertices.row(mesh.faces(face, corner)) / 3;
        const int sector = std::min(static_cast<int>(sectors * angleOf(middle)), sectors - 1);
        for (int corner = 0; corner < 3; ++corner)
            for (std::size_t side = 0; side < sides; ++side)
                points[static_cast<std::size_t>(sector)].push_back(
                    outer[static_cast<std::size_t>(mesh.faces(face, corner)) * sides + side]);
    }
    auto* compound = own<btCompoundShape>();
    for (const auto& sector : points)
        if (sector.size() >= 6)
            compound->addChildShape(bodyFromMesh(model), hull(sector));
    return compound;
}

btCollisionShape* CollisionShape::round(const RigidBodyModel& model) {
    const auto box = boundingBox(outerVertices(model));
    const Eigen::Vector3d half = box.sizes() / 2;
    btConvexShape* shape = nullptr;
    if (model.form == BodyForm::sphere) {
        shape = own<btSphereShape>(half.mean());
    } else {
        const double radius = half.head<2>().maxCoeff();
        shape = own<btCylinderShapeZ>(btVector3(radius, radius, half.z()));
        shape->setMargin(std::min(maximumMarginMetres, marginShare * half.minCoeff()));
    }
    auto* centred = own<btCompoundShape>();
    centred->addChildShape(btTransform(btQuaternion::getIdentity(), toBullet(box.center())), shape);
    return centred;
}

btCollisionShape* CollisionShape::ground(const RigidBodyModel& model) {
    return own<btStaticPlaneShape>(btVector3(0, 0, 1), boundingBox(outerVertices(model)).max().z());
}

btCollisionShape* CollisionShape::meshOf(const RigidBodyModel& model) {
    Mesh mesh = collisionSurface(*model.object, model.form);
    mesh.vertices *= model.sizeRatio;
    auto& triangles = *meshes.emplace_back(std::make_unique<btTriangleMesh>());
    const auto corner = [&](Eigen::Index face, int k) {
        return toBullet(Eigen::Vector3d(mesh.vertices.row(mesh.faces(face, k))));
    };
    for (Eigen::Index face = 0; face < mesh.faceCount(); ++face)
        triangles.addTriangle(corner(face, 0), corner(face, 1), corner(face, 2));
    auto* shape = own<SurfaceShape>(triangles, mesh);
    surfaceShape = shape;
    const bool isShell = model.object->body == BodyKind::shell;
    shape->setMargin(isShell ? model.sizeRatio * model.object->thicknessMetres / 2
                             : maximumMarginMetres);
    auto& map = *edges.emplace_back(std::make_unique<btTriangleInfoMap>());
    // Coinciding corners have the same bits. With its default threshold, 0.1 mm, Bullet ignores all
    // faces smaller than half a square centimetre.
    map.m_equalVertexThreshold = 1e-24;
    btGenerateInternalEdgeInfo(shape, &map);
    return shape;
}

} // namespace idiophone
