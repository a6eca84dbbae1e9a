// Measures quality scaling at fixed quality in the scene of rings. Finds the minimum mode budget at
// which the loudest objects sound as they do without a budget.
#pragma once

#include "Benchmarks/RingScene.h"

namespace idiophone {

struct FixedQuality {
    double modeBudget = 0;   ///< minimum found, to 2 %
    double worstErrorDb = 0; ///< of the loudest objects at this budget
    double mixPeak = 0;      ///< of the scene without a budget, full scale 1
};

inline constexpr std::size_t loudestJudged = 10;
inline constexpr double fixedQualityDb = -40;

/// Renders the scene repeatedly for `cells` cells with all `settings` except the budget. Judges the
/// ten objects of greatest energy by the energy of the difference from their unscaled render.
FixedQuality
findFixedQuality(const RingScene& scene, const SynthesisSettings& settings, std::size_t cells);

} // namespace idiophone
