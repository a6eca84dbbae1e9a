// A cell of continuous force: what something that scrapes or rolls does to an object meanwhile.
#pragma once

#include "Synth/Strike.h"
#include "Synth/SynthesisSettings.h"

#include <array>
#include <span>

namespace idiophone {

struct ForceCell {
    StrikePoint start, end; ///< where the contact is at the cell's start and at its end
    /// Unit vectors along which the force pushes there.
    std::array<float, 3> startDirection{0, 0, -1};
    std::array<float, 3> endDirection{0, 0, -1};
    std::span<const float, cellSamples> newtons;
};

} // namespace idiophone
