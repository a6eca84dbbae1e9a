// What an object is made of: elasticity, density, damping, and how it meets other things. Its file
// is MaterialFile's.
#pragma once

#include "Object/DampingLaw.h"
#include "Object/OrthotropicElasticity.h"
#include "Object/Result.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace idiophone {

/// A material (Raghuvanshi & Lin 2006, eq. 1), isotropic but for wood. The ranges are those of
/// `validated`: far wider than nature's.
struct Material {
    std::string name;           ///< at most 1000 bytes
    double youngsModulusPa = 0; ///< Y, 1 to 1e14; of wood along the grain
    double densityKgPerM3 = 0;  ///< ρ, 0.001 to 1e6
    double poissonRatio = 0;    ///< ν, −0.999 to 0.4999
    DampingLaw damping;         ///< γ to 1e6/s, η to 1 s, χ to 10
    double friction = 0;        ///< Coulomb coefficient against itself, 0 to 100
    double restitution = 0;     ///< 0 (dead) to 1 (elastic)
    double roughness = 0;       ///< 0 (polished) to 1 (rough-sawn)
    std::string source;         ///< where the figures come from; at most 32 KiB
    /// Of wood: finite elements go by it, all else takes the material for isotropic.
    std::optional<GrainRatios> grain = {};

    bool operator==(const Material&) const = default;
};

/// The material unchanged, or which figure is out of its range, or which text too long.
Result<Material> validated(Material material);

/// The named materials of Resources/Materials/materials.json, in the order in which the parameter
/// has them. Any thread; read when the program starts.
std::span<const Material> materialLibrary();

/// The library's material of that name (case-insensitive), or nullptr.
const Material* findMaterial(std::string_view name);

/// What the library's material of that name is drawn in, 0xRRGGBB.
std::optional<std::uint32_t> materialColour(std::string_view name);

/// The time in which a mode of that frequency decays by 60 dB: ln(1000)/α; infinity undamped.
double decaySeconds(const Material& material, double frequencyHz);

} // namespace idiophone
