#include "Console/StruckModes.h"

#include "Analysis/PulseSpectrum.h"
#include "Instrument/SettingsOfParameters.h"
#include "Synth/Listening.h"
#include "Synth/LiveConditions.h"
#include "Synth/PointShapes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

namespace idiophone {
StruckModes loudestModes(const ModalObject& object,
                         const Strike& strike,
                         const ParameterValues& parameters,
                         double sampleRateHz,
                         std::size_t count) {
    const auto law = liveConditions(object.material, synthesisSettings(parameters)).law;
    // φ·J and φ·ℓ of each mode, for an impulse J heard along ℓ.
    std::vector<float> struck(object.modeCount()), heard(object.modeCount());
    projectShapes(pointShapes(object, strike.point), strike.impulseNewtonSeconds,
                  listeningDirection(strike.point), object.modeCount(), struck.data(),
                  heard.data());
    StruckModes modes;
    for (std::size_t i = 0; i < object.modeCount(); ++i) {
        const double frequencyHz =
            dampedFrequency(law.pole(object.eigenvalues[i], object.damping(i))) /
            (2 * std::numbers::pi);
        const double residue =
            std::abs(static_cast<double>(struck[i]) * static_cast<double>(heard[i]));
        const double amplitude = residue * pulseSpectrum(frequencyHz * strike.durationSeconds);
        if (frequencyHz > 0 && frequencyHz < sampleRateHz / 2 && amplitude > 0)
            modes.push_back(
                {.frequencyHz = frequencyHz, .relativeDecibels = 20 * std::log10(amplitude)});
    }
    std::ranges::stable_sort(modes, std::greater{}, &StruckMode::relativeDecibels);
    modes.resize(std::min(modes.size(), count));
    for (auto& mode : modes | std::views::reverse)
        mode.relativeDecibels -= modes.front().relativeDecibels;
    return modes;
}

} // namespace idiophone
