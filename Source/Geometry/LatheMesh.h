// Meshes of surfaces of revolution: bowls, bells, shells. Triangles are nearly equilateral
// everywhere, even at the poles.
#pragma once

#include "Mesh/Mesh.h"

#include <vector>

namespace idiophone {

/// A point of the half section that turns around the z axis, with the wall thickness there.
struct LathePoint {
    double radiusMetres = 0; ///< ≥ 0; 0 only at the ends, where the surface closes in a pole
    double heightMetres = 0; ///< z
    double thicknessMetres = 0;

    bool operator==(const LathePoint&) const = default;
};

struct LatheMesh {
    Mesh mesh;                       ///< the middle surface
    Eigen::VectorXd thicknessMetres; ///< [N] linear along the section
};

/// Returns the surface of revolution of a section of at least two points. Faces look to the right
/// of the direction along the section (outward where it goes up). Corners over 30° are kept;
/// elsewhere points lie on the polyline in even steps. Every circle has a multiple of 12 vertices
/// (6 next to a pole), so that modes come in pairs as on the round body. Deterministic.
LatheMesh latheMesh(const std::vector<LathePoint>& section, double edgeMetres);

} // namespace idiophone
