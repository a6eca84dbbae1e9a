// The end by which a tine, tooth or tongue is held, while its other end is free.
#pragma once

#include "Analysis/Clamp.h"
#include "Analysis/UndercutBar.h"

#include <optional>

namespace idiophone {

/// The clamp is the section at the end x = length/2 of a bar whose top is the plane z = 0.
struct HeldEnd {
    /// Distance of the clamp from a bridge under the bar, over which the bar bends. 0: no bridge.
    double backMetres = 0;
    std::optional<double> resistanceNsPerM = {}, boardKgPerM2 = {}; ///< as in `Support`
};

/// Returns the bar with the edge of its arch over the bridge, because the elements have a line
/// there. The bar is uniform, so the arch does not change it.
UndercutBar withBridge(UndercutBar bar, const HeldEnd& end);

/// Returns the support of a bar that `withBridge` returned.
Support supportOf(const HeldEnd& end, const UndercutBar& bar);

/// Returns the length of a uniform bar whose free part has this fundamental, by Euler and Bernoulli
/// as if it were clamped at the bridge. It is too long for a bar that bends over a bridge.
double estimatedLengthMetres(const HeldEnd& end,
                             const UndercutBar& bar,
                             const BeamMaterial& material,
                             double fundamentalHz);

} // namespace idiophone
