#include "Editor/MaterialPlane.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

constexpr double planeOmega = 2 * std::numbers::pi * planeFrequencyHz;

double shareBetween(double value, double lowest, double highest) {
    return std::clamp(std::log(value / lowest) / std::log(highest / lowest), 0.0, 1.0);
}

double between(double share, double lowest, double highest) {
    return lowest * std::pow(highest / lowest, share);
}

/// Contributions of the three damping laws at the map's frequency, in 1/s.
std::array<double, 3> termsOf(const DampingLaw& damping) {
    return {damping.fluidPerSecond, damping.lossFactor * planeOmega,
            damping.viscoelasticSeconds * planeOmega * planeOmega};
}

} // namespace

PlanePlace placeOf(const Material& material) {
    return {.fast = shareBetween(std::sqrt(material.youngsModulusPa / material.densityKgPerM3),
                                 slowestMetresPerSecond, fastestMetresPerSecond),
            .ringing = shareBetween(decaySeconds(material, planeFrequencyHz), dullestSeconds,
                                    longestRingSeconds)};
}

double soundMetresPerSecond(const PlanePlace& place) {
    return between(place.fast, slowestMetresPerSecond, fastestMetresPerSecond);
}

double decaySecondsAt(const PlanePlace& place) {
    return between(place.ringing, dullestSeconds, longestRingSeconds);
}

Material materialAt(const PlanePlace& place, std::span<const Material> known) {
    constexpr double closest = 1e-9; // added to the squared distance: avoids division by zero
    double weights = 0, logDensity = 0;
    std::array<double, 3> kinds{};
    for (const auto& material : known) {
        const auto own = placeOf(material);
        const double weight = 1 / (closest + std::pow(own.fast - place.fast, 2) +
                                   std::pow(own.ringing - place.ringing, 2));
        const auto terms = termsOf(material.damping);
        const double total = terms[0] + terms[1] + terms[2];
        weights += weight;
        logDensity += weight * std::log(material.densityKgPerM3);
        for (std::size_t kind = 0; kind < kinds.size(); ++kind)
            kinds[kind] += total > 0 ? weight * terms[kind] / total : 0;
    }
    Material material;
    material.name = "Mixture";
    material.poissonRatio = known.front().poissonRatio;
    material.densityKgPerM3 = std::exp(logDensity / weights);
    material.youngsModulusPa = material.densityKgPerM3 * std::pow(soundMetresPerSecond(place), 2);
    const double sum = kinds[0] + kinds[1] + kinds[2];
    const double perSecond = 2 * std::log(1000) / decaySecondsAt(place); // d, twice the decay
    material.damping = {.fluidPerSecond = perSecond * kinds[0] / sum,
                        .viscoelasticSeconds =
                            perSecond * kinds[2] / sum / (planeOmega * planeOmega),
                        .lossFactor = perSecond * kinds[1] / sum / planeOmega};
    return material;
}

} // namespace idiophone
