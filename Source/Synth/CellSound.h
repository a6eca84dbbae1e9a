// SPDX-License-Identifier: Apache-2.0
// A cell of sound in each channel.
#pragma once

#include "Synth/ModalBankKernel.h"

#include <array>

namespace idiophone {

/// Maximum number of channels, one per listening direction. A merged group needs a state for each,
/// because its modes are heard in different proportions.
inline constexpr std::size_t maximumChannels = 2;

/// The buffers that each channel is added to.
using ChannelOutputs = std::array<float*, maximumChannels>;

using CellSound = std::array<std::array<float, cellSize>, maximumChannels>;

inline ChannelOutputs outputsOf(CellSound& sound) noexcept {
    return {sound[0].data(), sound[1].data()};
}

} // namespace idiophone
