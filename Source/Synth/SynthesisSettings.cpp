#include "Synth/SynthesisSettings.h"

#include <cmath>

namespace idiophone {

namespace {

bool positive(double value) {
    return value > 0 && std::isfinite(value);
}

/// Within these bounds the cube of a size and its reciprocal fit single precision.
bool validSize(double ratio) {
    return ratio >= 1e-6 && ratio <= 1e6;
}

bool notNegative(double value) {
    return value >= 0 && std::isfinite(value);
}

} // namespace

bool valid(const LiveMaterial& material) noexcept {
    return positive(material.youngsModulusPa) && positive(material.densityKgPerM3) &&
           notNegative(material.damping.fluidPerSecond) &&
           notNegative(material.damping.viscoelasticSeconds) &&
           notNegative(material.damping.lossFactor);
}

SynthesisSettings corrected(SynthesisSettings wanted, const SynthesisSettings& previous) noexcept {
    const auto keepUnless = [](bool good, double& value, double before) {
        if (!good)
            value = before;
    };
    keepUnless(wanted.tau >= 0 && std::isfinite(wanted.tau), wanted.tau, previous.tau);
    keepUnless(wanted.qualitySlope >= 0, wanted.qualitySlope, previous.qualitySlope);
    keepUnless(wanted.modeBudget >= 0, wanted.modeBudget, previous.modeBudget);
    keepUnless(wanted.compression >= 0, wanted.compression, previous.compression);
    keepUnless(validSize(wanted.sizeRatio), wanted.sizeRatio, previous.sizeRatio);
    keepUnless(wanted.thicknessRatio >= 0.1 && wanted.thicknessRatio <= 10, wanted.thicknessRatio,
               previous.thicknessRatio);
    keepUnless(wanted.imperfection >= 0 && wanted.imperfection <= 0.01, wanted.imperfection,
               previous.imperfection);
    keepUnless(wanted.radiation >= 0 && wanted.radiation <= 1, wanted.radiation,
               previous.radiation);
    keepUnless(positive(wanted.frequencyRatio), wanted.frequencyRatio, previous.frequencyRatio);
    if (wanted.material && !valid(*wanted.material))
        wanted.material = previous.material;
    return wanted;
}

} // namespace idiophone
