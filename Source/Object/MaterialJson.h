// SPDX-License-Identifier: Apache-2.0
// Reads and writes a material's figures and a wood's ratios as JSON, for material files and modal
// objects. Internal to Object.
#pragma once

#include "Object/Material.h"

#include <iterator>
#include <nlohmann/json.hpp>
#include <span>
#include <string>

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

struct GrainFigure {
    const char* key;
    double GrainRatios::*member;
};

inline constexpr GrainFigure grainFigures[] = {
    {"youngs_modulus_r", &GrainRatios::youngsModulusR},
    {"youngs_modulus_t", &GrainRatios::youngsModulusT},
    {"shear_modulus_lr", &GrainRatios::shearModulusLR},
    {"shear_modulus_rt", &GrainRatios::shearModulusRT},
    {"shear_modulus_lt", &GrainRatios::shearModulusLT},
    {"poisson_ratio_lr", &GrainRatios::poissonRatioLR},
    {"poisson_ratio_rt", &GrainRatios::poissonRatioRT},
    {"poisson_ratio_lt", &GrainRatios::poissonRatioLT},
};

template <class Json>
Json grainJson(const GrainRatios& grain) {
    auto result = Json::object();
    for (const auto& figure : grainFigures)
        result[figure.key] = grain.*figure.member;
    return result;
}

/// Fails if a ratio is missing, unknown or not a number. The error is the end of a sentence.
template <class Json>
Result<GrainRatios> grainFrom(const Json& object) {
    if (!object.is_object())
        return failure("'grain' is not a JSON object");
    GrainRatios grain;
    for (const auto& figure : grainFigures) {
        if (!object.contains(figure.key) || !object[figure.key].is_number())
            return failure("'grain' lacks a number '" + std::string(figure.key) + "'");
        grain.*figure.member = object[figure.key];
    }
    if (object.size() != std::size(grainFigures))
        return failure("'grain' has more than its eight ratios");
    return grain;
}

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
