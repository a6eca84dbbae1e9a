// Reads and writes a wood's ratios as JSON, for material files and modal objects. Internal to
// Object.
#pragma once

#include "Object/OrthotropicElasticity.h"

#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

namespace idiophone {

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

} // namespace idiophone
