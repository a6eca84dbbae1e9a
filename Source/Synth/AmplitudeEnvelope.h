// SPDX-License-Identifier: Apache-2.0
// An upper bound of an object's amplitude, which falls from period to period. Quality scaling ranks
// sleeping objects by it, at a cost that does not depend on their modes.
#pragma once

#include "Synth/ModePoles.h"

#include <array>
#include <cstdint>

namespace idiophone {

/// The modes form a few groups of ascending frequency. Each group falls as its slowest mode. All
/// members are for the audio thread.
class AmplitudeEnvelope {
public:
    /// The cells between two falls, about 10 ms.
    static constexpr int periodCells = 8;

    /// Call it after a change of poles or of the damper.
    void invalidateFalls() noexcept { isBehind = true; }
    /// Finds how far each group falls over a period. The damper δ acts in addition.
    void updateFalls(const ModePoles& poles, double dampingPerSecond) noexcept;

    /// Sets the bound to the summed amplitude of the audible modes, from energies [poles.size()].
    void set(const ModePoles& poles, const float* energies, std::int32_t modesRinging) noexcept;
    /// Adds the amplitude of state increments of these energies.
    void add(const ModePoles& poles, const float* energies) noexcept;
    /// Moves on by a period.
    void fall() noexcept {
        for (std::size_t k = 0; k < groups; ++k)
            bounds[k] *= falls[k];
    }
    void clear() noexcept;

    double amplitude() const noexcept { ///< m/s
        return (bounds[0] + bounds[1]) + (bounds[2] + bounds[3]);
    }
    /// Number of modes that rang when the bound was set.
    std::int32_t modesRinging() const noexcept { return ringing; }

private:
    static constexpr std::size_t groups = 4;

    static std::size_t endOf(std::size_t group, std::size_t modes) noexcept {
        return modes >> (groups - 1 - group);
    }

    std::array<float, groups> bounds{}; ///< m/s
    std::array<float, groups> falls{};  ///< over a period
    std::int32_t ringing = 0;
    bool isBehind = true; ///< of `falls`
};

} // namespace idiophone
