// SPDX-License-Identifier: Apache-2.0
#include "Object/OrthotropicElasticity.h"

#include <cmath>
#include <utility>

namespace idiophone {

Result<OrthotropicElasticity> validated(const OrthotropicElasticity& elasticity) {
    const auto& e = elasticity;
    for (const auto& [name, modulus] : {std::pair{"Young's modulus along L", e.youngsModulusLPa},
                                        std::pair{"Young's modulus along R", e.youngsModulusRPa},
                                        std::pair{"Young's modulus along T", e.youngsModulusTPa},
                                        std::pair{"shear modulus LR", e.shearModulusLRPa},
                                        std::pair{"shear modulus RT", e.shearModulusRTPa},
                                        std::pair{"shear modulus LT", e.shearModulusLTPa}})
        if (!(modulus > 0) || !std::isfinite(modulus))
            return failure("The " + std::string(name) + " must be a positive number of pascals.");
    const double lr = e.poissonRatioLR, rt = e.poissonRatioRT, lt = e.poissonRatioLT;
    const double rOfL = e.youngsModulusRPa / e.youngsModulusLPa;
    const double tOfR = e.youngsModulusTPa / e.youngsModulusRPa;
    const double tOfL = e.youngsModulusTPa / e.youngsModulusLPa;
    for (const auto& [name, share] :
         {std::pair{"LR", lr * lr * rOfL}, std::pair{"RT", rt * rt * tOfR},
          std::pair{"LT", lt * lt * tOfL}})
        if (!(share < 1))
            return failure("Poisson's ratio " + std::string(name) +
                           " is too large for the Young's moduli: no solid can have it.");
    // The determinant of the compliance of the normal strains, times E_L E_R E_T.
    if (!(1 - lr * lr * rOfL - rt * rt * tOfR - lt * lt * tOfL - 2 * lr * rt * lt * tOfL > 0))
        return failure("Poisson's ratios LR, RT and LT are together too large for the Young's "
                       "moduli: no solid can have them.");
    return elasticity;
}

OrthotropicElasticity orthotropicElasticity(double youngsModulusLPa, const GrainRatios& ratios) {
    const double y = youngsModulusLPa;
    return {.youngsModulusLPa = y,
            .youngsModulusRPa = y * ratios.youngsModulusR,
            .youngsModulusTPa = y * ratios.youngsModulusT,
            .shearModulusLRPa = y * ratios.shearModulusLR,
            .shearModulusRTPa = y * ratios.shearModulusRT,
            .shearModulusLTPa = y * ratios.shearModulusLT,
            .poissonRatioLR = ratios.poissonRatioLR,
            .poissonRatioRT = ratios.poissonRatioRT,
            .poissonRatioLT = ratios.poissonRatioLT};
}

OrthotropicElasticity isotropicElasticity(double youngsModulusPa, double poissonRatio) {
    const double shear = youngsModulusPa / (2 * (1 + poissonRatio));
    return {.youngsModulusLPa = youngsModulusPa,
            .youngsModulusRPa = youngsModulusPa,
            .youngsModulusTPa = youngsModulusPa,
            .shearModulusLRPa = shear,
            .shearModulusRTPa = shear,
            .shearModulusLTPa = shear,
            .poissonRatioLR = poissonRatio,
            .poissonRatioRT = poissonRatio,
            .poissonRatioLT = poissonRatio};
}

} // namespace idiophone
