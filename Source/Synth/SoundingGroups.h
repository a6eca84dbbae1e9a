// What is heard of one object's modes at a moment: what a picture of them needs, copied out of the
// synthesis. Plain data; it changes nothing.
#pragma once

#include "Synth/ModalPole.h"

#include <cstddef>
#include <cstdint>
#include <vector>

namespace idiophone {

enum class GroupStanding : std::uint8_t {
    belowTau,
    sounding,     ///< mixed
    beyondBudget, ///< above τ, and left out
    outOfBand,    ///< too low or too high to sound
    silenced
};

/// Memory is reserved by the constructor: `Synthesiser::report` fills it without allocating.
struct SoundingGroups {
    /// For the first `modes` modes of an object; what is beyond is left out.
    explicit SoundingGroups(std::size_t modes)
        : starts(modes + 1), amplitudes(modes), standings(modes) {}

    PoleLaw law;               ///< of the poles that hold
    double thicknessRatio = 1; ///< of the shell to that of its reference
    double tauPascals = 0;     ///< amplitudes below are dropped
    double compression = 1;
    /// The object is silent, and its groups are not yet those of `law` and `compression`.
    bool groupsAreBehind = false;
    std::size_t count = 0;                ///< G
    std::vector<std::int32_t> starts;     ///< [G+1] group g is modes starts[g] to starts[g+1] − 1
    std::vector<float> amplitudes;        ///< [G] |s| in m/s, of the louder channel
    std::vector<GroupStanding> standings; ///< [G]
};

} // namespace idiophone
