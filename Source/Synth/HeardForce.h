// SPDX-License-Identifier: Apache-2.0
// How a continuous force is heard over one cell.
#pragma once

#include "Synth/SynthesisSettings.h"

#include <array>

namespace idiophone {

/// The sound of an impulse of 1 N s between two points, in each channel.
struct ForceSound {
    using Channels = std::array<std::array<float, cellSamples>, 2>;

    alignas(64) Channels sound;
    alignas(64) Channels tube; ///< the tube's part of `sound`
};

/// It stays as it is throughout the cell, even if strikes change the modes meanwhile.
struct HeardForce {
    ForceSound start, end; ///< at the places where the cell starts and ends
    bool tubesPulse = false;
};

} // namespace idiophone
