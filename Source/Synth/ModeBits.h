// SPDX-License-Identifier: Apache-2.0
// Sets of modes as one bit each in blocks of `modeBlock`.
#pragma once

#include "Synth/ModalBankKernel.h"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

namespace idiophone {

inline bool isSet(unsigned bits, std::size_t g) noexcept {
    return (bits >> (g % modeBlock) & 1u) != 0;
}

inline std::uint16_t bitOf(std::size_t g) noexcept {
    return static_cast<std::uint16_t>(1u << (g % modeBlock));
}

/// Appends the mode of each set bit of a block.
inline void
appendModes(std::size_t block, unsigned bits, std::vector<std::int32_t>& modes) noexcept {
    for (; bits != 0; bits &= bits - 1)
        modes.push_back(static_cast<std::int32_t>(block * modeBlock) + std::countr_zero(bits));
}

/// Keeps the modes with the largest energies. Of two equal modes, keeps the one with the lower
/// index.
inline void
keepLoudest(std::vector<std::int32_t>& modes, const float* energies, std::size_t maximum) noexcept {
    if (modes.size() <= maximum)
        return;
    const auto cut = modes.begin() + static_cast<std::ptrdiff_t>(maximum);
    std::nth_element(modes.begin(), cut, modes.end(), [&](std::int32_t a, std::int32_t b) {
        return energies[a] != energies[b] ? energies[a] > energies[b] : a < b;
    });
    modes.erase(cut, modes.end());
}

} // namespace idiophone
