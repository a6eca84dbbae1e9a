// SPDX-License-Identifier: Apache-2.0
#include "Synth/ModeMix.h"

#include <algorithm>

namespace idiophone {

void MixBatch::mix(std::span<const ModeRun> runs,
                   const SubBlockStates& ahead,
                   float* output) const noexcept {
    for (const ModeRun& run : runs) {
        const std::size_t runFirst = std::max(index(run.first), first);
        const std::size_t runEnd = std::min(index(run.first + run.count), end);
        if (runFirst < runEnd)
            mixModes(tables + 2 * subBlockSamples * runFirst, ahead, runFirst - first,
                     runEnd - runFirst, subBlockCount, output);
    }
}

void MixBatch::mix(std::span<const ModePart> parts,
                   SubBlockStates& ahead,
                   float* output) const noexcept {
    for (const ModePart& part : parts) {
        const std::size_t g = index(part.mode);
        if (g < first || g >= end)
            continue;
        const std::size_t place = g - first;
        for (std::size_t b = 0; b < subBlockCount; ++b) {
            ahead.x[b][place] *= part.share;
            ahead.y[b][place] *= part.share;
        }
        mixModes(tables + 2 * subBlockSamples * g, ahead, place, 1, subBlockCount, output);
    }
}

} // namespace idiophone
