// SPDX-License-Identifier: Apache-2.0
// Fades modes out and in without a click. It renders the next 3 ms of their sound under a raised
// cosine into a separate buffer. So the bank only knows modes that are in or out, and modes that
// are struck during a fade need no special case.
#pragma once

#include "Synth/ModalBank.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Memory that the faders of one synthesiser share, so that it stays in the cache.
struct FadeRoom {
    FadeRoom(std::size_t modes, std::size_t channels) : states(modes, channels) {
        runs.reserve(modes);
    }

    std::vector<float> window; ///< raised cosine from 1 to 0, in whole cells
    ModeStates states;         ///< [G], 0 between two calls
    std::vector<ModeRun> runs;
};

/// Memory is reserved by the constructor; every other member is for the audio thread.
class ModeFader {
public:
    /// All faders that share the room have one sample rate. It must outlive this object.
    ModeFader(FadeRoom& room, double sampleRateHz);

    /// Fades out the given share of each mode from the next sample on, because the mode is no
    /// longer rendered. A share below 0 fades in: the mode is rendered in full from now on, and the
    /// fade subtracts the held-back part.
    void change(ModalBank& bank,
                std::span<const std::int32_t> modes,
                std::span<const float> shares) noexcept;

    /// Adds the next cell of the fades and moves on by a cell.
    void addCell(const ChannelOutputs& cell) noexcept;

    /// Multiplies the remaining fades by `factor`.
    void scale(float factor) noexcept;

    /// Copies the first channel's fades to the second.
    void widen() noexcept;

    bool active() const noexcept { return remaining > 0; }
    void reset() noexcept;

private:
    FadeRoom& room;
    /// The rest of the fades in each channel, from its next sample.
    std::array<std::vector<float>, maximumChannels> tails;
    std::size_t channels = 1;
    std::size_t remaining = 0; ///< samples of the tails that may not be zero
};

} // namespace idiophone
