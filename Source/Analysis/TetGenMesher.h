// TetGen behind a plain function. Internal to Analysis: TetMesh is what others see.
#pragma once

#include "Geometry/Mesh.h"
#include "Object/Result.h"

#include <atomic>
#include <mutex>

namespace idiophone {

struct TetGenSettings {
    bool keepSurface = true;                      ///< no new points on the surface (-Y)
    double radiusEdgeRatio = 2;                   ///< bound on circumradius over shortest edge (-q)
    double maximumVolumeM3 = 0;                   ///< of a tetrahedron (-a); 0 for no bound
    int maximumAddedPoints = -1;                  ///< (-S); −1 for no bound
    const std::atomic<bool>* cancelled = nullptr; ///< true ends it within a fraction of a second
};

/// Four-node tetrahedra over the convex hull of nothing but the surface's inside.
struct LinearTetrahedra {
    Eigen::MatrixXd points;     ///< [P×3] those of the surface first, in its order
    Eigen::MatrixXi tetrahedra; ///< [T×4]
    Eigen::VectorXi regions;    ///< [T] number of the closed-off part of space, ≥ 0
};

/// Whoever is in TetGen, whose arithmetic has globals (exactinit), holds it.
std::mutex& tetGenTurn();

/// See `tetrahedralise`. No exception leaves it; a stopped one fails with `cancelledMessage`, also
/// while it waits for its turn.
Result<LinearTetrahedra> runTetGen(const Mesh& surface, const TetGenSettings& settings);

} // namespace idiophone
