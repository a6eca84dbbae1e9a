// Ramps the strength of a force from one grid point to the next.
#pragma once

#include "Synth/SynthesisSettings.h"

#include <cstddef>
#include <span>

namespace idiophone {

/// Multiplies a cell by gains on a line that begins at the last sample of the previous cell. Any
/// thread; does not allocate.
inline void applyGainRamp(std::span<float, cellSamples> newtons, double from, double to) noexcept {
    const auto start = static_cast<float>(from);
    const auto step = (static_cast<float>(to) - start) / cellSamples;
    for (std::size_t i = 0; i < newtons.size(); ++i)
        newtons[i] *= start + static_cast<float>(i + 1) * step;
}

} // namespace idiophone
