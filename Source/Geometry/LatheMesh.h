// Surfaces of revolution, as a lathe turns them: bowls, bells, shells. Triangles are near
// equilateral all over, also at the poles.
#pragma once

#include "Geometry/Mesh.h"

#include <vector>

namespace idiophone {

/// A point of the half section that is turned about the z axis, and how thick the wall is there.
struct LathePoint {
    double radiusMetres = 0; ///< ≥ 0; 0 only at the ends, where the surface then closes in a pole
    double heightMetres = 0; ///< z
    double thicknessMetres = 0;
};

struct LatheMesh {
    Mesh mesh;                       ///< the middle surface
    Eigen::VectorXd thicknessMetres; ///< [N] linear along the section
};

/// The surface of this section, at least two points. Faces look to the right of the way along it
/// (outward where it goes up). Corners of over 30° stay; elsewhere points lie on the polyline in
/// even steps. Every circle has a number of vertices that repeats twelve times, six by the pole, so
/// that modes come in pairs as on the round body. Deterministic.
LatheMesh latheMesh(const std::vector<LathePoint>& section, double edgeMetres);

} // namespace idiophone
