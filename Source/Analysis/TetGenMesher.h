// TetGen behind a plain function. Internal to Analysis; other modules use TetMesh.
#pragma once

#include "Mesh/Mesh.h"
#include "Object/Result.h"

#include <atomic>
#include <mutex>

namespace idiophone {

struct TetGenSettings {
    bool keepSurface = true;                      ///< no new points on the surface (-Y)
    double radiusEdgeRatio = 2;                   ///< bound on circumradius over shortest edge (-q)
    double maximumVolumeM3 = 0;                   ///< of a tetrahedron (-a); 0: no limit
    int maximumAddedPoints = -1;                  ///< (-S); −1: no limit
    const std::atomic<bool>* cancelled = nullptr; ///< true ends it within a fraction of a second
};

/// Four-node tetrahedra that fill the inside of a surface.
struct LinearTetrahedra {
    Eigen::MatrixXd points;     ///< [P×3] the surface's points first, in its order
    Eigen::MatrixXi tetrahedra; ///< [T×4]
    Eigen::VectorXi regions;    ///< [T] index of the closed-off part of space, ≥ 0
};

/// Lock this mutex during every call of TetGen, whose arithmetic uses globals (exactinit).
std::mutex& tetGenTurn();

/// See `tetrahedralise`. Throws no exception. A cancelled call fails with `cancelledMessage`, also
/// while it waits for its turn.
Result<LinearTetrahedra> runTetGen(const Mesh& surface, const TetGenSettings& settings);

} // namespace idiophone
