// What an object is made of: elasticity, density, damping, and how it meets other things.
#pragma once

#include "Object/Result.h"

#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// An isotropic material with Rayleigh damping (Raghuvanshi & Lin 2006, eq. 1 and 2).
/// A mode of undamped angular frequency ω decays at α = (γ + η ω²)/2 per second.
struct Material {
    std::string name;
    double youngsModulusPa = 0;            ///< Y, > 0
    double densityKgPerM3 = 0;             ///< ρ, > 0
    double poissonRatio = 0;               ///< ν, −1 < ν < 0.5
    double fluidDampingPerSecond = 0;      ///< γ ≥ 0, multiplies the mass matrix
    double viscoelasticDampingSeconds = 0; ///< η ≥ 0, multiplies the stiffness matrix
    double friction = 0;                   ///< Coulomb coefficient against itself, ≥ 0
    double restitution = 0;                ///< 0 (dead) to 1 (elastic)
    double roughness = 0;                  ///< 0 (polished) to 1 (rough-sawn)
    std::string source;                    ///< where the figures come from

    bool operator==(const Material&) const = default;
};

/// The material unchanged, or which figure is out of its range.
Result<Material> validated(Material material);

/// The named materials, in a fixed order: parameters and presets count on it, so append only.
std::span<const Material> materialLibrary();

/// The library's material of that name (case-insensitive), or nullptr.
const Material* findMaterial(std::string_view name);

/// The time in which a mode of that frequency decays by 60 dB: ln(1000)/α.
double decaySeconds(const Material& material, double frequencyHz);

} // namespace idiophone
