// Which triangles of a boundary share an unknown, where there are too many for one each. Internal
// to Analysis.
#pragma once

#include "Analysis/BoundaryRow.h"
#include "Analysis/SurfaceSymmetry.h"

#include <Eigen/Core>
#include <vector>

namespace idiophone {

struct SharedUnknowns {
    std::vector<int> ofOrbits; ///< which unknown each orbit shares
    std::vector<int> targets;  ///< of each unknown the orbit at whose first face it is collocated
};

/// One for each orbit; or, where these are more, clusters of neighbours whose normals are alike.
SharedUnknowns sharedUnknowns(const std::vector<BoundaryPanel>& panels,
                              const SurfaceOrbits& orbits,
                              Eigen::Index maximumUnknowns);

} // namespace idiophone
