// Stress from strain in a body's own axes, isotropic or along a grain: what finite elements
// integrate. It is linear and the same everywhere in the body.
#pragma once

#include "Object/Material.h"
#include "Object/OrthotropicElasticity.h"

#include <Eigen/Core>
#include <optional>

namespace idiophone {

using Matrix6d = Eigen::Matrix<double, 6, 6>;

/// Voigt order xx, yy, zz, yz, xz, xy with engineering shear strains (γ_yz = 2 ε_yz).
struct ElasticLaw {
    Matrix6d stiffnessPa; ///< symmetric, positive definite
};

/// How the grain of a body of wood lies.
struct GrainAxes {
    Eigen::Vector3d grain = Eigen::Vector3d::UnitX(); ///< L, of any length but 0
    /// Which way the growth rings face; made perpendicular to the grain. Left empty, R is as near
    /// to z as it can be (to y when the grain runs along z).
    std::optional<Eigen::Vector3d> radial = {};
};

/// The law of constants that pass `validated` along axes L, R and T = L × R. Errors: constants that
/// no solid has, or directions that are zero or parallel.
Result<ElasticLaw> elasticLaw(const OrthotropicElasticity& elasticity, const GrainAxes& axes = {});

/// Of a material that passes `validated`: isotropic, or of wood along the axes, which are
/// neither zero nor parallel.
ElasticLaw elasticLaw(const Material& material, const GrainAxes& axes = {});

/// √(C/ρ) of the slowest plane wave, over all directions and polarisations: √(G/ρ) when isotropic.
/// Sampled in 642 directions.
double slowestShearSpeedMetresPerSecond(const ElasticLaw& law, double densityKgPerM3);

/// The least Young's modulus over the same directions.
double leastYoungsModulusPa(const ElasticLaw& law);

} // namespace idiophone
