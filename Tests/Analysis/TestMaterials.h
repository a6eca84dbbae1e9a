// Materials with round numbers, for closed forms.
#pragma once

#include "Object/Material.h"

#include <Eigen/Core>
#include <numbers>

namespace idiophone::test {

/// REFERENCE 1.3's bar.
inline Material referenceWood(double poissonRatio = 0.25) {
    Material material;
    material.name = "Reference wood";
    material.youngsModulusPa = 20e9;
    material.densityKgPerM3 = 1000;
    material.poissonRatio = poissonRatio;
    material.damping.fluidPerSecond = 10;
    material.damping.viscoelasticSeconds = 1e-7;
    return material;
}

inline Eigen::VectorXd frequenciesHz(const Eigen::VectorXd& eigenvalues) {
    return eigenvalues.cwiseSqrt() / (2 * std::numbers::pi);
}

} // namespace idiophone::test
