// SPDX-License-Identifier: Apache-2.0
// How one slot of the synthesiser sounds, for displays and reports.
#pragma once

#include <cstdint>

namespace idiophone {

struct SlotStatus {
    float amplitude = 0;            ///< summed amplitude of the modes, m/s; asleep: a bound
    std::int32_t modesRinging = 0;  ///< above τ; asleep: at most
    std::int32_t modesMixed = 0;    ///< modes within the slot's share of the budget
    std::int32_t channels = 0;      ///< channels of its sound; a single one goes to both
    std::int32_t share = 0;         ///< modes that the budget granted, at most the ringing ones
    std::int32_t groups = 0;        ///< groups of modes, after compression
    std::int32_t groupsAudible = 0; ///< groups within the band and not silenced
};

} // namespace idiophone
