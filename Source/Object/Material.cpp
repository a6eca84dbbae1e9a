#include "Object/Material.h"

#include "Object/OneLine.h"

#include <array>
#include <charconv>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

/// Short, and with a point whatever the locale of the host.
std::string written(double value) {
    std::array<char, 32> text{};
    const auto [end, fault] =
        std::to_chars(text.data(), text.data() + text.size(), value, std::chars_format::general, 6);
    return {text.data(), end};
}

} // namespace

Result<Material> validated(Material material) {
    struct Rule {
        const char* what;
        double value;
        double lowest;
        double highest;
    };
    // Far wider than nature, so that invented materials pass and nonsense does not.
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
    for (const auto& rule : rules)
        if (!(rule.value >= rule.lowest && rule.value <= rule.highest)) // also catches NaN
            return failure("material " + inQuotes(material.name) + ": the " + rule.what +
                           " is out of range: " + written(rule.value));
    if (material.grain)
        if (const auto constants =
                validated(orthotropicElasticity(material.youngsModulusPa, *material.grain));
            !constants)
            return failure("material " + inQuotes(material.name) + ": " +
                           constants.error().message);
    return material;
}

double decaySeconds(const Material& material, double frequencyHz) {
    const double omega = 2 * std::numbers::pi * frequencyHz;
    return 2 * std::log(1000.0) / material.damping.perSecond(omega * omega);
}

} // namespace idiophone
