// Which triangles of a boundary share an unknown, where there are too many for one each. Internal
// to Analysis.
#pragma once

#include "Analysis/BoundaryRow.h"
#include "Analysis/SurfaceSymmetry.h"

#include <Eigen/Core>
#include <vector>

namespace idiophone {

/// The most equations of an unknown. With one, weak modes of plates are off by up to 24 dB, with
/// three by 4.
inline constexpr Eigen::Index mostCollocations = 3;

/// An orbit at whose first face an equation is collocated, and how much it counts in that of its
/// unknown.
struct Collocation {
    int orbit = 0;
    double share = 1;
};

struct SharedUnknowns {
    std::vector<int> ofOrbits; ///< [orbits] which unknown each has
    Eigen::Index count = 0;
    std::vector<Collocation> collocations; ///< the shares of each unknown's sum to 1
};

/// Each orbit has its own; or, where there are more orbits than that, clusters of neighbours whose
/// normals are alike share one. Its equation is the mean of those of a few of them: that of one
/// alone would depend on where in the cluster it lies.
SharedUnknowns sharedUnknowns(const std::vector<BoundaryPanel>& panels,
                              const SurfaceOrbits& orbits,
                              Eigen::Index maximumUnknowns);

} // namespace idiophone
