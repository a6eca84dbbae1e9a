// SPDX-License-Identifier: Apache-2.0
// The opening of the tubes under the bars by a motor's discs, over one cell.
#pragma once

#include "Synth/SynthesisSettings.h"

#include <cstddef>

namespace idiophone {

/// A gain of the tubes' sound, from 1 (open) to 0 (closed). It is linear and starts at the last
/// sample of the previous cell.
struct TubeOpening {
    float start = 1;
    float end = 1;

    bool isFull() const noexcept { return start == 1 && end == 1; }
    float at(std::size_t sampleInCell) const noexcept {
        return start + static_cast<float>(sampleInCell + 1) / cellSamples * (end - start);
    }
};

} // namespace idiophone
