// SPDX-License-Identifier: Apache-2.0
#include "Synth/LiveConditions.h"

#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

double ratio(double value, double reference) noexcept {
    return value > 0 && reference > 0 ? value / reference : 1;
}

/// Returns the eigenvalue ratio at which the mode sounds at its pitch.
double ratioKeeping(const PitchMode& pitch,
                    double thicknessRatio,
                    double frequencyRatio,
                    const DampingLaw& damping,
                    double extraRatio) noexcept {
    const double omega = 2 * std::numbers::pi * pitch.hz * frequencyRatio;
    const double ownEigenvalue =
        pitch.eigenvalue + (thicknessRatio * thicknessRatio - 1) * pitch.bending;
    const ModeDamping mode{pitch.damping.scale, extraRatio * pitch.damping.extraPerSecond};
    return stiffnessSoundingAt(omega, damping, mode, ownEigenvalue) / ownEigenvalue;
}

} // namespace

double LiveConditions::frequencyRatio() const noexcept {
    return std::sqrt(law.eigenvalueRatio);
}

LiveConditions liveConditions(const Material& reference,
                              const SynthesisSettings& settings,
                              double slotSizeRatio,
                              double slotFrequencyRatio,
                              const PitchMode* pitch) noexcept {
    const LiveMaterial material = settings.material.value_or(liveMaterial(reference));
    const double size = slotSizeRatio * settings.sizeRatio;
    const double frequencies = settings.frequencyRatio * slotFrequencyRatio;
    const double tuning = frequencies / size;
    const double density = ratio(material.densityKgPerM3, reference.densityKgPerM3);
    const double stiffness = ratio(material.youngsModulusPa, reference.youngsModulusPa);
    const double faster = 1 / settings.decayRatio;
    const DampingLaw damping = material.damping.times(faster);
    LiveConditions result;
    result.law = {.eigenvalueRatio = settings.keepPitch && pitch != nullptr
                                         ? ratioKeeping(*pitch, settings.thicknessRatio,
                                                        frequencies, damping, faster)
                                         : stiffness / density * tuning * tuning,
                  .damping = damping,
                  .extraRatio = faster};
    result.gainRatio = 1 / (density * size * size * size);
    // At equal frequency times size, the radiated pressure is proportional to frequency · shape ·
    // area.
    result.radiationGainRatio = result.gainRatio * size;
    result.radiationRatio = result.frequencyRatio() * size;
    return result;
}

} // namespace idiophone
