// Modes that leave or return without a click: what they would sound for 3 ms under a raised cosine
// is rendered ahead into a buffer of its own, so that the bank itself only knows modes that are in
// or out, and modes that are struck while they fade need no special case.
#pragma once

#include "Synth/ModalBank.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace idiophone {

/// Memory is reserved by the constructor; every other member is for the audio thread.
class ModeFader {
public:
    /// For modes of this bank.
    ModeFader(const ModalBank& bank, double sampleRateHz);

    /// Fades out, from the next sample to be played on, the share of each mode that is no longer
    /// rendered. A share below 0 fades in: the mode is rendered in full from there on, and what the
    /// fade holds back is taken away.
    void change(ModalBank& bank,
                std::span<const std::int32_t> modes,
                std::span<const float> shares) noexcept;

    /// Adds the next cell of the fades and moves on.
    void addCell(const ChannelOutputs& cell) noexcept;

    /// Multiplies what is left to play.
    void scale(float factor) noexcept;

    /// The second channel goes on as a copy of the first.
    void widen() noexcept;

    bool active() const noexcept { return remaining > 0; }
    void reset() noexcept;

private:
    void take(const ModalBank& bank, std::int32_t mode, double share) noexcept;
    void fade(ModalBank& bank, std::span<const std::int32_t> modes) noexcept;

    std::vector<float> window; ///< raised cosine from 1 to 0, in whole cells
    /// What is left to play in each channel, from its next sample.
    std::array<std::vector<float>, mostChannels> tails;
    ModeStates states;
    std::vector<ModeRun> runs;
    std::size_t channels = 1;
    std::size_t remaining = 0; ///< samples of the tails that may not be zero
};

} // namespace idiophone
