// Hooke's law of a material with three planes of symmetry, such as wood. It knows nothing of how
// the axes lie in a body.
#pragma once

#include "Object/Result.h"

namespace idiophone {

/// The nine engineering constants along the axes L (along the grain), R (radial) and T (tangential
/// to the growth rings). ν_LR is the contraction along R under stress along L, over the extension
/// along L; the other three follow from ν_RL / E_R = ν_LR / E_L.
struct OrthotropicElasticity {
    double youngsModulusLPa = 0, youngsModulusRPa = 0, youngsModulusTPa = 0; ///< > 0
    double shearModulusLRPa = 0, shearModulusRTPa = 0, shearModulusLTPa = 0; ///< > 0
    double poissonRatioLR = 0, poissonRatioRT = 0, poissonRatioLT = 0;

    bool operator==(const OrthotropicElasticity&) const = default;
};

/// A wood's constants over Young's modulus along the grain, as tables of woods give them: they move
/// little from one piece to the next.
struct GrainRatios {
    double youngsModulusR = 1, youngsModulusT = 1;                           ///< > 0
    double shearModulusLR = 0.4, shearModulusRT = 0.4, shearModulusLT = 0.4; ///< > 0
    double poissonRatioLR = 0.25, poissonRatioRT = 0.25, poissonRatioLT = 0.25;

    bool operator==(const GrainRatios&) const = default;
};

OrthotropicElasticity orthotropicElasticity(double youngsModulusLPa, const GrainRatios& ratios);

/// The constants unchanged, or in one sentence why no solid can have them: a modulus that is not
/// positive, or a strain that would release energy (Lempriere 1968: the compliance is not positive
/// definite).
Result<OrthotropicElasticity> validated(const OrthotropicElasticity& elasticity);

/// The same stiffness in all directions: E, E, E, G = E/(2(1+ν)) and ν.
OrthotropicElasticity isotropicElasticity(double youngsModulusPa, double poissonRatio);

} // namespace idiophone
