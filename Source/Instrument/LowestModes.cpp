#include "Instrument/LowestModes.h"

#include "Synth/LiveConditions.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace idiophone {

LowestModes::LowestModes(const ModalObject& object, double sizeRatio) {
    for (std::size_t mode = 0; mode < object.modeCount() && count < capacity; ++mode) {
        const double hz = std::sqrt(object.eigenvalues[mode]) / (2 * std::numbers::pi) / sizeRatio;
        if (count > 0 && hz < 1.01 * frequenciesHz[count - 1])
            continue;
        frequenciesHz[count] = hz;
        dampingScales[count++] = object.dampingScale(mode);
    }
}

LowestModes LowestModes::moved(double ratio) const {
    LowestModes result = *this;
    for (double& hz : result.frequenciesHz)
        hz = std::max(lowestSoundingHz, hz * ratio);
    return result;
}

double liveFrequencyRatio(const Material& own, const SynthesisSettings& settings) {
    return liveConditions(own, settings).frequencyRatio();
}

} // namespace idiophone
