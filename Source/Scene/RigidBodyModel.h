// What rigid motion needs of a kind of body: its mass about its own axes, and how hard and how
// round it is where others touch it.
#pragma once

#include "Geometry/BoxTree.h"
#include "Geometry/Mesh.h"
#include "Object/ModalObject.h"
#include "Scene/Scene.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>

namespace idiophone {

/// Immutable; shared by all bodies of a kind. Mesh coordinates are the object's own, in metres, as
/// large as the body is; body coordinates have its centre of mass as their origin and its principal
/// axes of inertia. Of fixed bodies both are the same.
struct RigidBodyModel {
    std::shared_ptr<const ModalObject> object; ///< not null
    BodyForm form = BodyForm::hull;
    bool isFixed = false;
    double sizeRatio = 1;
    double massKg = 0;
    Eigen::Vector3d inertiaKgM2; ///< about the body's axes
    Eigen::Isometry3d meshFromBody;
    double friction = 0;
    double restitution = 0;
    double rollingFrictionMetres = 0;
    double contactRadiusMetres = 0;
    double compliancePerPa = 0;   ///< (1 − ν²)/E
    BoxSearch touchingFaces = {}; ///< of a surface: what it takes to make its shape
};

/// Of an object whose surface others meet.
inline constexpr std::size_t mostSurfaceFaces = 100'000;
/// Of a scene's surfaces together, which takes a second or two: a sound mesh has some ten pairs a
/// face, and under a hundred boxes.
inline constexpr BoxSearch mostTouchingFaces{.pairs = 5'000'000, .boxes = 50'000'000};

/// The error names the kind and why it cannot move: an object without mass, one so flat that the
/// form has no inside, or where the form is its surface one without faces, or with too many of
/// them. `likeSurface` is a surface of the same object, which then is not looked at again, or null.
Result<std::shared_ptr<const RigidBodyModel>>
makeRigidBodyModel(const BodyTemplate& kind,
                   std::shared_ptr<const ModalObject> object,
                   const RigidBodyModel* likeSurface = nullptr);

/// The object's faces as others meet them, smoothed where they are few, not scaled; none without an
/// area, and of those on the same vertices one.
Mesh collisionSurface(const ModalObject& object);

/// The vertices of the surface in mesh coordinates; of a shell those of both sides.
std::vector<Eigen::Vector3d> outerVertices(const RigidBodyModel& model);

/// Of the curvatures of two bodies that touch, together.
double relativeRadiusMetres(const RigidBodyModel& first, const RigidBodyModel& second);

/// How long two bodies touch that meet at a speed > 0, after Hertz (Mallet.h).
double contactSeconds(const RigidBodyModel& first,
                      const RigidBodyModel& second,
                      double effectiveMassKg,
                      double metresPerSecond);

/// Around all of them.
Eigen::AlignedBox3d boundingBox(const std::vector<Eigen::Vector3d>& points);

} // namespace idiophone
