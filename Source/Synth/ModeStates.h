// SPDX-License-Identifier: Apache-2.0
// The states of modes in each channel.
#pragma once

#include "Synth/AlignedVector.h"
#include "Synth/CellSound.h"
#include "Synth/ModalPole.h"

#include <algorithm>

namespace idiophone {

struct ModeStates {
    ModeStates(std::size_t modes, std::size_t channels) {
        for (std::size_t c = 0; c < channels; ++c) {
            x[c].resize(modes);
            y[c].resize(modes);
        }
    }

    ModalState at(std::size_t g, std::size_t channel) const noexcept {
        return {x[channel][g], y[channel][g]};
    }
    void set(std::size_t g, std::size_t channel, const ModalState& state) noexcept {
        x[channel][g] = state.x;
        y[channel][g] = state.y;
    }
    /// Returns the squared amplitude bound of a mode in the louder of `channels`.
    float energy(std::size_t g, const ModalPole& pole, std::size_t channels) const noexcept {
        double largest = 0;
        for (std::size_t c = 0; c < channels; ++c)
            largest = std::max(largest, amplitudeBound(pole, at(g, c)));
        return static_cast<float>(largest * largest);
    }

    std::array<AlignedVector<double>, maximumChannels> x, y;
};

} // namespace idiophone
