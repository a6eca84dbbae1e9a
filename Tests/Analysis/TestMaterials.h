// Materials with round numbers for comparison with closed forms.
#pragma once

#include "Object/Material.h"

#include <Eigen/Core>
#include <numbers>

namespace idiophone::test {

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

/// Round numbers like those of a hardwood, but of no species.
inline constexpr OrthotropicElasticity roundWood{.youngsModulusLPa = 16e9,
                                                 .youngsModulusRPa = 2e9,
                                                 .youngsModulusTPa = 1e9,
                                                 .shearModulusLRPa = 1.2e9,
                                                 .shearModulusRTPa = 0.3e9,
                                                 .shearModulusLTPa = 0.9e9,
                                                 .poissonRatioLR = 0.3,
                                                 .poissonRatioRT = 0.5,
                                                 .poissonRatioLT = 0.4};

inline Eigen::VectorXd frequenciesHz(const Eigen::VectorXd& eigenvalues) {
    return eigenvalues.cwiseSqrt() / (2 * std::numbers::pi);
}

} // namespace idiophone::test
