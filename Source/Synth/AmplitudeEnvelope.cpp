// SPDX-License-Identifier: Apache-2.0
#include "Synth/AmplitudeEnvelope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace idiophone {

void AmplitudeEnvelope::updateFalls(const ModePoles& poles, double dampingPerSecond) noexcept {
    if (!std::exchange(isBehind, false))
        return;
    const double seconds = periodCells * static_cast<double>(cellSize) * poles.sampleSeconds();
    std::size_t g = 0;
    for (std::size_t k = 0; k < groups; ++k) {
        double slowest = std::numeric_limits<double>::infinity();
        for (; g < endOf(k, poles.size()); ++g)
            slowest = std::min(slowest, decayBound(poles.pole(g)));
        falls[k] = static_cast<float>(std::exp(-(slowest + dampingPerSecond) * seconds));
    }
}

void AmplitudeEnvelope::set(const ModePoles& poles,
                            const float* energies,
                            std::int32_t modesRinging) noexcept {
    bounds = {};
    add(poles, energies);
    ringing = modesRinging;
}

void AmplitudeEnvelope::add(const ModePoles& poles, const float* energies) noexcept {
    const float* audible = poles.audibleWeights();
    std::size_t g = 0;
    for (std::size_t k = 0; k < groups; ++k)
        for (; g < endOf(k, poles.size()); ++g)
            bounds[k] += std::sqrt(energies[g] * audible[g]);
}

void AmplitudeEnvelope::clear() noexcept {
    bounds = {};
    ringing = 0;
}

} // namespace idiophone
