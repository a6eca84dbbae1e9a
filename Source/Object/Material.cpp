// SPDX-License-Identifier: Apache-2.0
#include "Object/Material.h"

#include "Object/NumberText.h"
#include "Object/OneLine.h"

#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

// The texts go into the header of an object's file, which is limited to 1 MiB.
constexpr std::size_t longestNameBytes = 1000, longestSourceBytes = 32 * 1024;

} // namespace

Result<Material> validated(Material material) {
    struct Rule {
        const char* what;
        double value;
        double lowest;
        double highest;
    };
    // The ranges are far wider than in nature, so that invented materials pass and nonsense fails.
    const Rule rules[] = {
        {"Young's modulus (Pa)", material.youngsModulusPa, 1, 1e14},
        {"density (kg/m³)", material.densityKgPerM3, 1e-3, 1e6},
        {"Poisson ratio", material.poissonRatio, -0.999, 0.4999},
        {"fluid damping γ (1/s)", material.damping.fluidPerSecond, 0, 1e6},
        {"visco-elastic damping η (s)", material.damping.viscoelasticSeconds, 0, 1},
        {"loss factor", material.damping.lossFactor, 0, 10},
        {"friction", material.friction, 0, 100},
        {"restitution", material.restitution, 0, 1},
        {"roughness", material.roughness, 0, 1},
    };
    const auto refuse = [&](const std::string& fault) {
        return failure("material " + inQuotes(material.name) + ": " + fault);
    };
    for (const auto& rule : rules)
        if (!(rule.value >= rule.lowest && rule.value <= rule.highest)) // also rejects NaN
            return refuse(std::string("the ") + rule.what +
                          " is out of range: " + numberText(rule.value));
    if (material.name.size() > longestNameBytes)
        return refuse("its name is longer than " + std::to_string(longestNameBytes) + " bytes");
    if (material.source.size() > longestSourceBytes)
        return refuse("its source is longer than " + std::to_string(longestSourceBytes) + " bytes");
    if (material.grain)
        if (const auto constants =
                validated(orthotropicElasticity(material.youngsModulusPa, *material.grain));
            !constants)
            return refuse(constants.error().message);
    return material;
}

double decaySeconds(const Material& material, double frequencyHz) {
    const double omega = 2 * std::numbers::pi * frequencyHz;
    return 2 * std::log(1000.0) / material.damping.perSecond(omega * omega);
}

} // namespace idiophone
