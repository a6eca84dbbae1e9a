// SPDX-License-Identifier: Apache-2.0
#include "Synth/SynthesisSettings.h"

#include <cmath>

namespace idiophone {

namespace {

bool positive(double value) {
    return value > 0 && std::isfinite(value);
}

bool notNegative(double value) {
    return value >= 0 && std::isfinite(value);
}

struct Range {
    double SynthesisSettings::*setting;
    double lowest, highest;
};

using Limits = std::numeric_limits<double>;
constexpr Range ranges[] = {
    {&SynthesisSettings::tau, 0, Limits::max()},
    {&SynthesisSettings::qualitySlope, 0, Limits::infinity()},
    {&SynthesisSettings::modeBudget, 0, Limits::infinity()},
    {&SynthesisSettings::compression, 0, Limits::infinity()},
    {&SynthesisSettings::sizeRatio, 1e-6, 1e6}, // so that its cube fits single precision
    {&SynthesisSettings::thicknessRatio, 0.1, 10},
    {&SynthesisSettings::imperfection, 0, 0.01},
    {&SynthesisSettings::frequencyRatio, Limits::min(), Limits::max()},
    {&SynthesisSettings::decayRatio, 0.01, 100},
    {&SynthesisSettings::radiation, 0, 1},
};

} // namespace

bool valid(const LiveMaterial& material) noexcept {
    return positive(material.youngsModulusPa) && positive(material.densityKgPerM3) &&
           notNegative(material.damping.fluidPerSecond) &&
           notNegative(material.damping.viscoelasticSeconds) &&
           notNegative(material.damping.lossFactor);
}

SynthesisSettings corrected(SynthesisSettings wanted, const SynthesisSettings& previous) noexcept {
    for (const auto& [setting, lowest, highest] : ranges)
        if (!(wanted.*setting >= lowest && wanted.*setting <= highest))
            wanted.*setting = previous.*setting;
    if (wanted.material && !valid(*wanted.material))
        wanted.material = previous.material;
    return wanted;
}

} // namespace idiophone
