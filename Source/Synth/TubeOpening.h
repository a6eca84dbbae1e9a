// How far a motor's discs open the tubes under the bars while a cell sounds.
#pragma once

#include "Synth/SynthesisSettings.h"

#include <cstddef>

namespace idiophone {

/// A gain of what comes out of the tubes, from 1 (open) to 0 (closed). It follows a line that
/// begins at the last sample of the cell before.
struct TubeOpening {
    float start = 1;
    float end = 1;

    bool isFull() const noexcept { return start == 1 && end == 1; }
    float at(std::size_t sampleInCell) const noexcept {
        return start + static_cast<float>(sampleInCell + 1) / cellSamples * (end - start);
    }
};

} // namespace idiophone
