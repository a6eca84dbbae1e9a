// SPDX-License-Identifier: Apache-2.0
// Hooke's law of a material with three planes of symmetry, such as wood. Independent of the
// orientation of the axes in a body.
#pragma once

#include "Object/Result.h"

namespace idiophone {

/// The nine engineering constants along the axes L (along the grain), R (radial) and T (tangential
/// to the growth rings). ν_LR is the contraction along R divided by the extension along L under
/// stress along L. The other three ratios follow from ν_RL / E_R = ν_LR / E_L.
struct OrthotropicElasticity {
    double youngsModulusLPa = 0, youngsModulusRPa = 0, youngsModulusTPa = 0; ///< > 0
    double shearModulusLRPa = 0, shearModulusRTPa = 0, shearModulusLTPa = 0; ///< > 0
    double poissonRatioLR = 0, poissonRatioRT = 0, poissonRatioLT = 0;

    bool operator==(const OrthotropicElasticity&) const = default;
};

/// A wood's constants divided by Young's modulus along the grain, as in tables of woods: they vary
/// little between pieces.
struct GrainRatios {
    double youngsModulusR = 1, youngsModulusT = 1;                           ///< > 0
    double shearModulusLR = 0.4, shearModulusRT = 0.4, shearModulusLT = 0.4; ///< > 0
    double poissonRatioLR = 0.25, poissonRatioRT = 0.25, poissonRatioLT = 0.25;

    bool operator==(const GrainRatios&) const = default;
};

OrthotropicElasticity orthotropicElasticity(double youngsModulusLPa, const GrainRatios& ratios);

/// Returns the constants unchanged, or one sentence why no solid can have them. Either a modulus is
/// not positive, or the compliance is not positive definite, so that a strain would release energy
/// (Lempriere 1968).
Result<OrthotropicElasticity> validated(const OrthotropicElasticity& elasticity);

/// Returns equal stiffness in all directions: E, E, E, G = E/(2(1+ν)) and ν.
OrthotropicElasticity isotropicElasticity(double youngsModulusPa, double poissonRatio);

} // namespace idiophone
