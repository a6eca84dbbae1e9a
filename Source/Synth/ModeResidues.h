// SPDX-License-Identifier: Apache-2.0
// The residues of modes: how loudly and in which phase a strike at one point is heard in each mode.
#pragma once

#include "Synth/AlignedVector.h"
#include "Synth/CellSound.h"

#include <algorithm>

namespace idiophone {

/// Complex residues of the modes in one channel, zero in the padding. A mode of state s sounds Re(r
/// s), so the imaginary part gives the acceleration over the frequency.
struct ChannelResidues {
    AlignedVector<float> re;
    AlignedVector<float> im;

    void resize(std::size_t modes) {
        re.resize(modes);
        im.resize(modes);
    }
    /// Copies the first `modes`, which must fit.
    void copyFrom(const ChannelResidues& other, std::size_t modes) noexcept {
        std::copy_n(other.re.begin(), modes, re.begin());
        std::copy_n(other.im.begin(), modes, im.begin());
    }
};
using ModeResidues = std::array<ChannelResidues, maximumChannels>;

} // namespace idiophone
