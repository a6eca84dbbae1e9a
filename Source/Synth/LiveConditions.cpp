#include "Synth/LiveConditions.h"

#include <cmath>

namespace idiophone {
namespace {

double ratio(double value, double reference) noexcept {
    return value > 0 && reference > 0 ? value / reference : 1;
}

} // namespace

bool soundsAt(const ModalPole& pole, double sampleRateHz) noexcept {
    const double hz = naturalFrequencyHz(pole);
    return hz >= lowestSoundingHz && hz < highestSoundingShare * sampleRateHz;
}

double LiveConditions::frequencyRatio() const noexcept {
    return std::sqrt(law.eigenvalueRatio);
}

LiveConditions liveConditions(const Material& reference,
                              const SynthesisSettings& settings,
                              double slotSizeRatio,
                              double slotFrequencyRatio) noexcept {
    const LiveMaterial material = settings.material.value_or(liveMaterial(reference));
    const double size = slotSizeRatio * settings.sizeRatio;
    const double tuning = settings.frequencyRatio * slotFrequencyRatio / size;
    const double density = ratio(material.densityKgPerM3, reference.densityKgPerM3);
    const double stiffness = ratio(material.youngsModulusPa, reference.youngsModulusPa);
    LiveConditions result;
    result.law = {.eigenvalueRatio = stiffness / density * tuning * tuning,
                  .damping = material.damping};
    result.gainRatio = 1 / (density * size * size * size);
    // At equal frequency times size the radiated pressure goes as frequency · shape · area.
    result.radiationGainRatio = result.gainRatio * size;
    result.radiationRatio = result.frequencyRatio() * size;
    return result;
}

} // namespace idiophone
