#include "Instrument/SettingsOfParameters.h"

#include "Object/Material.h"

#include <cmath>

namespace idiophone {
namespace {

using enum ParameterId;

std::optional<LiveMaterial> liveMaterial(const ParameterValues& values) {
    const int choice = static_cast<int>(values[material]);
    if (choice == customMaterial)
        return LiveMaterial{.youngsModulusPa = values[youngsModulus] * 1e9,
                            .densityKgPerM3 = values[density],
                            .fluidDampingPerSecond = values[fluidDamping],
                            .viscoelasticDampingSeconds = values[viscoelasticDamping] * 1e-6};
    const auto library = materialLibrary();
    const auto index = static_cast<std::size_t>(choice - firstLibraryMaterial);
    if (choice < firstLibraryMaterial || index >= library.size())
        return std::nullopt;
    return LiveMaterial{.youngsModulusPa = library[index].youngsModulusPa,
                        .densityKgPerM3 = library[index].densityKgPerM3,
                        .fluidDampingPerSecond = library[index].fluidDampingPerSecond,
                        .viscoelasticDampingSeconds = library[index].viscoelasticDampingSeconds};
}

} // namespace

SynthesisSettings synthesisSettings(const ParameterValues& values, double bendSemitones) {
    const double slope = values[qualitySlope];
    return {.tau = values[tau],
            .qualitySlope = slope == parameterInfo(qualitySlope).maximum ? greedySlope : slope,
            .modeBudget = values[modeBudget],
            .compression = values[compression],
            .sizeRatio = values[size],
            .frequencyRatio = std::exp2((values[tune] / 100 + bendSemitones) / 12),
            .material = liveMaterial(values)};
}

} // namespace idiophone
