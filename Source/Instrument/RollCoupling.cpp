#include "Instrument/RollCoupling.h"

#include <numbers>

namespace idiophone {

CoupledModes coupledModes(const LowestModes& lowestModes,
                          const SynthesiserSlot& slot,
                          const SynthesisSettings& settings) {
    const auto law = liveConditions(slot, settings).law;
    static_assert(LowestModes::capacity <= ContactForce::maxCoupledModes);
    const auto modes = lowestModes.atThickness(settings.thicknessRatio);
    CoupledModes result;
    for (std::size_t mode = 0; mode < modes.count; ++mode) {
        const double omega = 2 * std::numbers::pi * modes.frequenciesHz[mode];
        const auto pole = law.pole(omega * omega, modes.dampingScales[mode]);
        if (naturalFrequencyHz(pole) >= lowestSoundingHz && isOscillating(pole))
            result.add({.frequencyHz = dampedFrequency(pole) / (2 * std::numbers::pi),
                        .dampingPerSecond = pole.damping / 2});
    }
    return result;
}

} // namespace idiophone
