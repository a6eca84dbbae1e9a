// A contact of a mallet with an object, from its start to its end.
#pragma once

#include "Synth/CellSound.h"
#include "Synth/Listening.h"
#include "Synth/Strike.h"

#include <array>
#include <complex>
#include <cstdint>
#include <numbers>

namespace idiophone {

/// G0 and H of a contact (StrikeKernel.h), summed over some modes, for each channel.
struct ForcedMotion {
    std::array<double, maximumChannels> steadyVelocity{};
    std::array<std::complex<double>, maximumChannels> swing{};
};

/// The forced part of a strike's response. The free part is in the states of the modes.
struct Contact {
    Strike strike;       ///< duration kept clear of resonances
    Listening listening; ///< at the start of the contact
    std::int64_t startCell = 0;
    double startSample = 0;
    ForcedMotion mixed{}; ///< of the mixed modes
    ForcedMotion tube{};  ///< the tube's part of `mixed`

    /// Returns e^{iΩt} at a sample of a cell.
    std::complex<double>
    phaseAt(std::int64_t cell, double sample, double sampleRateHz) const noexcept {
        const double cells = static_cast<double>(cell - startCell);
        const double samples = cells * static_cast<int>(cellSize) + sample - startSample;
        const double turns = samples / (sampleRateHz * strike.durationSeconds);
        return std::polar(1.0, 2 * std::numbers::pi * turns);
    }
};

} // namespace idiophone
