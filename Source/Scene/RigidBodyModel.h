// The data of a kind of body for rigid motion: mass, axes of inertia, and the stiffness and
// roundness of its surface.
#pragma once

#include "Geometry/BoxTree.h"
#include "Mesh/Mesh.h"
#include "Object/ModalObject.h"
#include "Scene/Scene.h"

#include <Eigen/Geometry>
#include <cstddef>
#include <memory>

namespace idiophone {

/// Immutable; all bodies of a kind share it. Mesh coordinates are the object's, in metres, scaled
/// to the body's size. Body coordinates start at the centre of mass and follow the principal axes
/// of inertia. For fixed bodies both are the same.
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
    BoxSearch touchingFaces = {}; ///< for a surface: the work to build its shape
};

/// The maximum number of faces of an object whose form is `surface`.
inline constexpr std::size_t maximumSurfaceFaces = 100'000;
/// The maximum work for all surfaces of a scene, which takes a second or two. Sound meshes have
/// about ten pairs and under a hundred boxes per face.
inline constexpr BoxSearch maximumTouchingFaces{.pairs = 5'000'000, .boxes = 50'000'000};

/// The error names the kind and the reason. An object may have no mass or be too flat for its form.
/// A surface may have no faces or too many.
Result<std::shared_ptr<const RigidBodyModel>>
makeRigidBodyModel(const BodyTemplate& kind, std::shared_ptr<const ModalObject> object);

/// Returns the object's faces for collisions, not scaled. For the form `surface`, coarse meshes are
/// smoothed. Faces without area and duplicates are removed.
Mesh collisionSurface(const ModalObject& object, BodyForm form = BodyForm::surface);

/// Returns the surface vertices in mesh coordinates. A shell has vertices on both sides.
std::vector<Eigen::Vector3d> outerVertices(const RigidBodyModel& model);

/// Returns the combined radius of curvature of two bodies in contact.
double relativeRadiusMetres(const RigidBodyModel& first, const RigidBodyModel& second);

/// Returns the Hertz contact time of two bodies that meet at a speed > 0 (Mallet.h).
double contactSeconds(const RigidBodyModel& first,
                      const RigidBodyModel& second,
                      double effectiveMassKg,
                      double metresPerSecond);

Eigen::AlignedBox3d boundingBox(const std::vector<Eigen::Vector3d>& points);

} // namespace idiophone
