// Makes small modal objects with known modes, for tests without a mesh analysis.
#pragma once

#include "Object/ModalObject.h"

#include <cmath>
#include <numbers>
#include <vector>

namespace idiophone::test {

/// Returns a flat square of 4 vertices; every mode moves every vertex along z by its `gain`
/// (1/√kg).
inline ModalObject syntheticObject(const std::vector<double>& frequenciesHz,
                                   std::vector<float> gains = {}) {
    ModalObject object;
    object.name = "synthetic";
    object.material = {.name = "Test",
                       .youngsModulusPa = 1e10,
                       .densityKgPerM3 = 1000,
                       .poissonRatio = 0.3,
                       .damping = {.fluidPerSecond = 5, .viscoelasticSeconds = 1e-8},
                       .friction = 0.5,
                       .restitution = 0.5,
                       .roughness = 0.5,
                       .source = "made up"};
    object.body = BodyKind::shell;
    object.thicknessMetres = 0.01;
    object.method = "synthetic";
    object.bandHz = 44000;
    object.vertices = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
    object.faces = {0, 1, 2, 0, 2, 3};
    object.shapeVertices = {0, 1, 2, 3};
    object.mass = {
        .massKg = 1, .centreMetres = {0.5, 0.5, 0}, .inertiaKgM2 = {1, 0, 0, 0, 1, 0, 0, 0, 1}};
    gains.resize(frequenciesHz.size(), 1.0f);
    for (const double frequencyHz : frequenciesHz)
        object.eigenvalues.push_back(std::pow(2 * std::numbers::pi * frequencyHz, 2));
    for (std::size_t row = 0; row < object.shapeVertices.size(); ++row)
        for (const float gain : gains)
            object.shapes.insert(object.shapes.end(), {0, 0, gain});
    return object;
}

} // namespace idiophone::test
