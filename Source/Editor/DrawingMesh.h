// The mesh that the picture draws: finer than the object's own, with thickness and smooth normals.
#pragma once

#include "Object/ModalObject.h"

#include <Eigen/Geometry>
#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

/// The shape of an object, as far as the picture treats shapes differently.
enum class Form {
    free,
    box,   ///< its vertices lie on its bounding box, such as a bar or a die
    turned ///< round about the z axis, such as a bell or a tube
};

/// A place on an object's mesh: vertices, and their weights with the sum 1.
struct MeshPlace {
    std::array<std::int32_t, 3> vertices{};
    std::array<float, 3> weights{};
};

/// Three corners a face, in the object's coordinates and metres.
struct DrawingMesh {
    struct Corner {
        Eigen::Vector3f place, normal; ///< normal: unit, or zero if the face has no area
        MeshPlace onMesh;
    };
    std::vector<Corner> corners;
    Form form = Form::free;
    bool isClosed = false;
};

/// Open sheets get their thickness. Faces of round objects are divided and bent (Phong
/// tessellation; Boubekeur & Alexa 2008) while the result has at most `maximumFaces`, so that their
/// outlines are round. Takes time proportional to the faces.
DrawingMesh drawingMesh(const ModalObject& object, std::size_t maximumFaces);

/// The sides of a box, for objects with too many faces. Its corners have no place on a mesh.
DrawingMesh boxMesh(const Eigen::AlignedBox3d& box);

} // namespace idiophone
