#include "Object/Material.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <numbers>

namespace idiophone {
namespace {

// Elasticity and damping after the sources named. Friction, restitution and roughness are handbook
// orders of magnitude for the material against itself.
const std::array library{
    Material{.name = "Rosewood",
             .youngsModulusPa = 12.5e9,
             .densityKgPerM3 = 850,
             .poissonRatio = 0.25,
             .fluidDampingPerSecond = 51.58,
             .viscoelasticDampingSeconds = 2.35e-7,
             .friction = 0.4,
             .restitution = 0.6,
             .roughness = 0.5,
             .source = "Damping: Chaigne & Doutaut 1997, Table I; elasticity: a bar-tuning code's "
                       "Honduran rosewood"},
    Material{.name = "Padauk",
             .youngsModulusPa = 11.7e9,
             .densityKgPerM3 = 750,
             .poissonRatio = 0.25,
             .fluidDampingPerSecond = 12.44,
             .viscoelasticDampingSeconds = 9.16e-8,
             .friction = 0.4,
             .restitution = 0.6,
             .roughness = 0.5,
             .source = "Damping: Chaigne & Doutaut 1997, Table I; elasticity: fem3d_rust_2 guide"},
    Material{.name = "Wood",
             .youngsModulusPa = 1.1e10,
             .densityKgPerM3 = 750,
             .poissonRatio = 0.25,
             .fluidDampingPerSecond = 60,
             .viscoelasticDampingSeconds = 2e-6,
             .friction = 0.4,
             .restitution = 0.5,
             .roughness = 0.6,
             .source = "KleinPAT Table 4"},
    Material{.name = "Ceramic",
             .youngsModulusPa = 7.2e10,
             .densityKgPerM3 = 2700,
             .poissonRatio = 0.19,
             .fluidDampingPerSecond = 6,
             .viscoelasticDampingSeconds = 1e-7,
             .friction = 0.5,
             .restitution = 0.7,
             .roughness = 0.3,
             .source = "KleinPAT Table 4"},
    Material{.name = "Glass",
             .youngsModulusPa = 6.2e10,
             .densityKgPerM3 = 2600,
             .poissonRatio = 0.20,
             .fluidDampingPerSecond = 1,
             .viscoelasticDampingSeconds = 1e-7,
             .friction = 0.4,
             .restitution = 0.8,
             .roughness = 0.05,
             .source = "KleinPAT Table 4"},
    Material{.name = "Plastic",
             .youngsModulusPa = 1.4e9,
             .densityKgPerM3 = 1070,
             .poissonRatio = 0.35,
             .fluidDampingPerSecond = 30,
             .viscoelasticDampingSeconds = 1e-6,
             .friction = 0.35,
             .restitution = 0.6,
             .roughness = 0.2,
             .source = "KleinPAT Table 4"},
    Material{.name = "Iron",
             .youngsModulusPa = 2.1e11,
             .densityKgPerM3 = 8000,
             .poissonRatio = 0.28,
             .fluidDampingPerSecond = 5,
             .viscoelasticDampingSeconds = 1e-7,
             .friction = 0.6,
             .restitution = 0.7,
             .roughness = 0.4,
             .source = "KleinPAT Table 4"},
    Material{.name = "Polycarbonate",
             .youngsModulusPa = 2.4e9,
             .densityKgPerM3 = 1190,
             .poissonRatio = 0.37,
             .fluidDampingPerSecond = 0.5,
             .viscoelasticDampingSeconds = 4e-7,
             .friction = 0.3,
             .restitution = 0.6,
             .roughness = 0.1,
             .source = "KleinPAT Table 4"},
    Material{.name = "Steel",
             .youngsModulusPa = 2.0e11,
             .densityKgPerM3 = 7850,
             .poissonRatio = 0.29,
             .fluidDampingPerSecond = 5,
             .viscoelasticDampingSeconds = 3e-8,
             .friction = 0.6,
             .restitution = 0.8,
             .roughness = 0.1,
             .source = "KleinPAT Table 4"},
    Material{.name = "Tin",
             .youngsModulusPa = 5e10,
             .densityKgPerM3 = 7265,
             .poissonRatio = 0.325,
             .fluidDampingPerSecond = 2,
             .viscoelasticDampingSeconds = 3e-8,
             .friction = 0.4,
             .restitution = 0.5,
             .roughness = 0.2,
             .source = "NeuralSound material set"},
    Material{.name = "Aluminium",
             .youngsModulusPa = 68.9e9,
             .densityKgPerM3 = 2700,
             .poissonRatio = 0.33,
             .fluidDampingPerSecond = 0.5,
             .viscoelasticDampingSeconds = 1e-8,
             .friction = 0.5,
             .restitution = 0.8,
             .roughness = 0.1,
             .source =
                 "6061 alloy, handbook; damping: within the handbook's 0.1-1 1/s, 5e-9-2e-8 s"},
};

bool sameName(std::string_view a, std::string_view b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
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
        {"fluid damping γ (1/s)", material.fluidDampingPerSecond, 0, 1e6},
        {"visco-elastic damping η (s)", material.viscoelasticDampingSeconds, 0, 1},
        {"friction", material.friction, 0, 100},
        {"restitution", material.restitution, 0, 1},
        {"roughness", material.roughness, 0, 1},
    };
    for (const auto& rule : rules)
        if (!(rule.value >= rule.lowest && rule.value <= rule.highest)) // also catches NaN
            return failure("material '" + material.name + "': the " + rule.what +
                           " is out of range: " + std::to_string(rule.value));
    return material;
}

std::span<const Material> materialLibrary() {
    return library;
}

const Material* findMaterial(std::string_view name) {
    const auto found = std::ranges::find_if(
        library, [&](const Material& material) { return sameName(material.name, name); });
    return found == library.end() ? nullptr : &*found;
}

double decaySeconds(const Material& material, double frequencyHz) {
    const double omega = 2 * std::numbers::pi * frequencyHz;
    return 2 * std::log(1000.0) /
           (material.fluidDampingPerSecond + material.viscoelasticDampingSeconds * omega * omega);
}

} // namespace idiophone
