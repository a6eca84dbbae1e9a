// Stress from strain in the body's axes, isotropic or along a grain, for finite elements. The law
// is linear and the same everywhere in the body.
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

/// Strain–displacement matrix B: the Voigt strain of a displacement u that varies along the
/// gradient n is B u.
Eigen::Matrix<double, 6, 3> strainAlong(const Eigen::Vector3d& n);

/// The directions of the grain in a wooden body, neither zero nor parallel.
struct GrainAxes {
    Eigen::Vector3d grain = Eigen::Vector3d::UnitX(); ///< L
    /// The normal of the growth rings; it is made perpendicular to the grain. If empty, R is as
    /// near to z as possible (to y if the grain runs along z).
    std::optional<Eigen::Vector3d> radial = {};
};

/// Returns the law of constants that pass `validated`, along the axes L, R and T = L × R.
ElasticLaw elasticLaw(const OrthotropicElasticity& elasticity, const GrainAxes& axes = {});

/// Returns the law of a material that passes `validated`. Wood follows the axes, other materials
/// are isotropic.
ElasticLaw elasticLaw(const Material& material, const GrainAxes& axes = {});

/// Returns √(C/ρ) of the slowest plane wave over all directions and polarisations, √(G/ρ) if
/// isotropic. It samples 642 directions.
double slowestShearSpeedMetresPerSecond(const ElasticLaw& law, double densityKgPerM3);

/// Returns the minimum Young's modulus over the same directions.
double minimumYoungsModulusPa(const ElasticLaw& law);

} // namespace idiophone
