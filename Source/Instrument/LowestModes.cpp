#include "Instrument/LowestModes.h"

#include "Synth/LiveConditions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

LowestModes::LowestModes(const ModalObject& object) {
    for (std::size_t mode = 0; mode < object.modeCount() && count < capacity; ++mode) {
        const double hz = std::sqrt(object.eigenvalues[mode]) / (2 * std::numbers::pi);
        if (count > 0 && hz < 1.01 * frequenciesHz[count - 1])
            continue;
        frequenciesHz[count] = hz;
        if (object.hasLiveThickness())
            bendingShares[count] = object.bending[mode] / object.eigenvalues[mode];
        dampingScales[count++] = object.dampingScale(mode);
    }
}

LowestModes LowestModes::atThickness(double thicknessRatio) const {
    LowestModes result = *this;
    for (std::size_t mode = 0; mode < count; ++mode)
        result.frequenciesHz[mode] *=
            std::sqrt(1 + (thicknessRatio * thicknessRatio - 1) * bendingShares[mode]);
    return result;
}

LowestModes LowestModes::moved(double ratio) const {
    LowestModes result = *this;
    for (double& hz : result.frequenciesHz)
        hz = std::max(lowestSoundingHz, hz * ratio);
    return result;
}

} // namespace idiophone
