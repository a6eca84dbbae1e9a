// Which triangles of a boundary share an unknown, where there are too many for one each. Internal
// to Analysis.
#pragma once

#include "Analysis/BoundaryRow.h"
#include "Analysis/SurfaceSymmetry.h"

#include <Eigen/Core>
#include <vector>

namespace idiophone {

/// [orbits] which unknown each has: its own; or, where there are more orbits than unknowns, that of
/// a cluster of neighbours whose normals are alike.
std::vector<int> sharedUnknowns(const std::vector<BoundaryPanel>& panels,
                                const SurfaceOrbits& orbits,
                                Eigen::Index maximumUnknowns);

} // namespace idiophone
