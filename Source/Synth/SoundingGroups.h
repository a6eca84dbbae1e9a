// SPDX-License-Identifier: Apache-2.0
// A snapshot of one object's groups of modes for display, copied out of the synthesis. Plain data;
// reading it changes nothing.
#pragma once

#include "Synth/ModalPole.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

enum class GroupStanding : std::uint8_t {
    belowTau,
    sounding,     ///< mixed
    beyondBudget, ///< above τ, but over the budget
    outOfBand,    ///< too low or too high to sound
    silenced
};

/// Memory is reserved by the constructor, so that `Synthesiser::report` fills it without
/// allocating.
struct SoundingGroups {
    /// Holds the first `modes` modes of an object and ignores the rest.
    explicit SoundingGroups(std::size_t modes)
        : starts(modes + 1), amplitudes(modes), standings(modes) {}

    PoleLaw law;               ///< law of the current poles
    double thicknessRatio = 1; ///< thickness of the shell over the reference thickness
    double tauPascals = 0;     ///< smaller amplitudes are dropped
    double compression = 1;
    /// The object is silent, and its groups do not yet follow `law` and `compression`.
    bool groupsAreBehind = false;
    std::size_t count = 0;                ///< G
    std::vector<std::int32_t> starts;     ///< [G+1] group g is modes starts[g] to starts[g+1] − 1
    std::vector<float> amplitudes;        ///< [G] |s| in m/s, of the louder channel
    std::vector<GroupStanding> standings; ///< [G]
};

} // namespace idiophone
