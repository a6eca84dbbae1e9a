// Reads and writes a material's figures as JSON, for material files and modal objects. Internal to
// Object.
#pragma once

#include "Object/GrainJson.h"
#include "Object/Material.h"

#include <span>

namespace idiophone {

struct MaterialFigure {
    const char* key;
    double& (*of)(Material&);
};

inline constexpr MaterialFigure elasticityFigures[] = {
    {"youngs_modulus_pa", [](Material& m) -> double& { return m.youngsModulusPa; }},
    {"density_kg_per_m3", [](Material& m) -> double& { return m.densityKgPerM3; }},
    {"poisson_ratio", [](Material& m) -> double& { return m.poissonRatio; }},
};
inline constexpr MaterialFigure dampingFigures[] = {
    {"fluid_damping_per_s", [](Material& m) -> double& { return m.damping.fluidPerSecond; }},
    {"viscoelastic_damping_s",
     [](Material& m) -> double& { return m.damping.viscoelasticSeconds; }},
    {"loss_factor", [](Material& m) -> double& { return m.damping.lossFactor; }},
};
inline constexpr MaterialFigure contactFigures[] = {
    {"friction", [](Material& m) -> double& { return m.friction; }},
    {"restitution", [](Material& m) -> double& { return m.restitution; }},
    {"roughness", [](Material& m) -> double& { return m.roughness; }},
};
inline constexpr std::span<const MaterialFigure> materialFigureGroups[] = {
    elasticityFigures, dampingFigures, contactFigures};

/// Writes the name, the figures, the grain if there is one, and the source.
template <class Json>
Json materialJson(Material material) {
    Json result{{"name", material.name}};
    for (const auto group : materialFigureGroups)
        for (const auto& figure : group)
            result[figure.key] = figure.of(material);
    if (material.grain)
        result["grain"] = grainJson<Json>(*material.grain);
    result["source"] = material.source;
    return result;
}

} // namespace idiophone
