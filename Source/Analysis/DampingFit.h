// Fits a material's damping law to the decay rates of modes.
#pragma once

#include "Object/DampingLaw.h"

#include <span>

namespace idiophone {

struct DecayOfMode {
    double eigenvalue = 0;     ///< λ = ω² in rad²/s²
    double decayPerSecond = 0; ///< α > 0
    double weight = 1;         ///< > 0
};

/// Returns the law of γ, χ, η ≥ 0 with the smallest relative deviations of the decays. Deviating
/// decays count less (Huber's weights). Of several laws, takes the one with the fewest constants
/// that the data need (Schwarz's criterion). Nothing damps if `decays` is empty.
DampingLaw fittedDamping(std::span<const DecayOfMode> decays);

} // namespace idiophone
