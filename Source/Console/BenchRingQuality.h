// Quality scaling at fixed quality in the scene of rings: the smallest mode budget under which the
// loudest objects still sound as they do without one.
#pragma once

#include "Console/BenchRingScene.h"

namespace idiophone {

struct FixedQuality {
    double modeBudget = 0;   ///< the smallest found, to 2 %
    double worstErrorDb = 0; ///< of the loudest objects under it
    double mixPeak = 0;      ///< of the scene without a budget, full scale 1
};

inline constexpr std::size_t loudestJudged = 10;
inline constexpr double fixedQualityDb = -40;

/// Renders the scene over and over for `cells`; `settings` say all but the budget. The ten objects
/// of greatest energy are judged by the energy of the difference from their unscaled render.
FixedQuality
findFixedQuality(const RingScene& scene, const SynthesisSettings& settings, std::size_t cells);

} // namespace idiophone
