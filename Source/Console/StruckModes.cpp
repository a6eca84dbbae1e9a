#include "Console/StruckModes.h"

#include "Instrument/SettingsOfParameters.h"
#include "Synth/ModalPole.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <ranges>

namespace idiophone {
namespace {

constexpr double pi = std::numbers::pi;

PoleLaw lawOf(const ModalObject& object, const SynthesisSettings& settings) {
    const auto& own = object.material;
    const auto played = settings.material.value_or(
        LiveMaterial{.youngsModulusPa = own.youngsModulusPa,
                     .densityKgPerM3 = own.densityKgPerM3,
                     .fluidDampingPerSecond = own.fluidDampingPerSecond,
                     .viscoelasticDampingSeconds = own.viscoelasticDampingSeconds});
    return {.eigenvalueRatio = played.youngsModulusPa / own.youngsModulusPa * own.densityKgPerM3 /
                               played.densityKgPerM3 *
                               std::pow(settings.frequencyRatio / settings.sizeRatio, 2),
            .fluidDampingPerSecond = played.fluidDampingPerSecond,
            .viscoelasticDampingSeconds = played.viscoelasticDampingSeconds};
}

/// |F(f)| of the pulse (1 − cos 2πt/T)/T: sin(πx)/(πx(1 − x²)) with x = fT.
double pulseSpectrum(double x) {
    if (x < 1e-6)
        return 1;
    if (std::abs(x - 1) < 1e-6)
        return 0.5;
    return std::abs(std::sin(pi * x) / (pi * x * (1 - x * x)));
}

/// (φ·J)(φ·n): the modes of one point, for an impulse J heard along the normal n.
double residue(const ModalObject& object, const Strike& strike, std::size_t mode) {
    std::array<double, 3> shape{};
    for (std::size_t corner = 0; corner < 3; ++corner) {
        if (strike.point.weights[corner] == 0)
            continue;
        const auto row = static_cast<std::size_t>(strike.point.shapeRows[corner]);
        for (std::size_t axis = 0; axis < 3; ++axis)
            shape[axis] += strike.point.weights[corner] * object.shapesAt(row)[mode * 3 + axis];
    }
    double driven = 0, heard = 0;
    for (std::size_t axis = 0; axis < 3; ++axis) {
        driven += shape[axis] * strike.impulseNewtonSeconds[axis];
        heard += shape[axis] * strike.point.normal[axis];
    }
    return std::abs(driven * heard);
}

} // namespace

StruckModes loudestModes(const ModalObject& object,
                         const Strike& strike,
                         const ParameterValues& parameters,
                         double sampleRateHz,
                         std::size_t count) {
    const auto law = lawOf(object, synthesisSettings(parameters));
    StruckModes modes;
    for (std::size_t i = 0; i < object.modeCount(); ++i) {
        const double frequencyHz = dampedFrequency(law.pole(object.eigenvalues[i])) / (2 * pi);
        const double amplitude =
            residue(object, strike, i) * pulseSpectrum(frequencyHz * strike.durationSeconds);
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
