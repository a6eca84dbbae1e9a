// What an object is made of: elasticity, density, damping, and how it meets other things. Its file
// is MaterialFile's.
#pragma once

#include "Object/DampingLaw.h"
#include "Object/OrthotropicElasticity.h"
#include "Object/Result.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// A material (Raghuvanshi & Lin 2006, eq. 1), isotropic but for wood.
struct Material {
    std::string name;
    double youngsModulusPa = 0; ///< Y, > 0; of wood along the grain
    double densityKgPerM3 = 0;  ///< ρ, > 0
    double poissonRatio = 0;    ///< ν, −1 < ν < 0.5
    DampingLaw damping;
    double friction = 0;    ///< Coulomb coefficient against itself, ≥ 0
    double restitution = 0; ///< 0 (dead) to 1 (elastic)
    double roughness = 0;   ///< 0 (polished) to 1 (rough-sawn)
    std::string source;     ///< where the figures come from
    /// Of wood: finite elements go by it, all else takes the material for isotropic.
    std::optional<GrainRatios> grain = {};

    bool operator==(const Material&) const = default;
};

/// The material unchanged, or which figure is out of its range.
Result<Material> validated(Material material);

/// The named materials of Resources/Materials/materials.json, in its order: parameters and presets
/// count on it, so append only. Any thread; read when the program starts.
std::span<const Material> materialLibrary();

/// The library's material of that name (case-insensitive), or nullptr.
const Material* findMaterial(std::string_view name);

/// The time in which a mode of that frequency decays by 60 dB: ln(1000)/α; infinity undamped.
double decaySeconds(const Material& material, double frequencyHz);

} // namespace idiophone
