// Chooses the triangles of a boundary that share an unknown, if there are too many for one each.
// Internal to Analysis.
#pragma once

#include "Analysis/BoundaryRow.h"
#include "Analysis/SurfaceSymmetry.h"

#include <Eigen/Core>
#include <vector>

namespace idiophone {

/// Maximum number of equations per unknown. With one, weak modes of plates are off by up to 24 dB,
/// and with three by up to 4 dB.
inline constexpr Eigen::Index mostCollocations = 3;

/// An orbit whose first face has an equation, and its weight in the mean for its unknown.
struct Collocation {
    int orbit = 0;
    double share = 1;
};

struct SharedUnknowns {
    std::vector<int> ofOrbits; ///< [orbits] the unknown of each orbit
    Eigen::Index count = 0;
    std::vector<Collocation> collocations; ///< shares of one unknown sum to 1
};

/// Gives each orbit its own unknown. If there are more orbits than `maximumUnknowns`, clusters of
/// neighbours with similar normals share one. Its equation is the mean over a few members, because
/// a single one would depend on its place in the cluster.
SharedUnknowns sharedUnknowns(const std::vector<BoundaryPanel>& panels,
                              const SurfaceOrbits& orbits,
                              Eigen::Index maximumUnknowns);

} // namespace idiophone
