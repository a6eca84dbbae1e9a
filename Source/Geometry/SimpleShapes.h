// Meshes of simple shapes from a few sizes: a bar, a plate, a ring, a bowl.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <span>
#include <string_view>

namespace idiophone {

/// The sizes, 0.1 mm to 100 m. A shape ignores those that it does not have.
struct ShapeSizes {
    double lengthMetres = 0.4;         ///< of a bar, plate or box
    double widthMetres = 0.05;         ///< of a bar, plate or box
    double heightMetres = 0.02;        ///< of a box, hoop or bowl
    double radiusMetres = 0.1;         ///< of a disc, icosphere, ring or hoop, and of a bowl's rim
    double sectionRadiusMetres = 0.01; ///< of a ring's cross-section; less than its radius
    double footRadiusMetres = 0;       ///< of a bowl's flat foot; 0: two fifths of the rim's
    /// Thickness of a bowl's wall, which makes it a closed body; 0: an open surface without any.
    double thicknessMetres = 0;
    int vertexCount = 1000; ///< approximate, 12 to `maximumShapeVertices`
};

inline constexpr int maximumShapeVertices = 1000000; ///< proportions may double it

/// Returns "bar", "plate", "box", "disc", "icosphere", "ring", "hoop", "bowl".
std::span<const std::string_view> simpleShapeNames();

/// Returns the mesh of the shape of that name, in metres. A bar, plate or disc is flat. A bowl
/// stands on its foot and opens upward: a cup if its foot is nearly as wide as its rim. The error
/// is one sentence: sizes that contradict each other, or more than twice `maximumShapeVertices`.
Result<Mesh> simpleShape(std::string_view name, const ShapeSizes& sizes);

} // namespace idiophone
