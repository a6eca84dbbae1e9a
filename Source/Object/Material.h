// SPDX-License-Identifier: Apache-2.0
// A material: elasticity, density, damping and contact figures. MaterialFile reads and writes it.
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

/// A material (Raghuvanshi & Lin 2006, eq. 1), isotropic except for wood. `validated` checks the
/// ranges, which are far wider than in nature.
struct Material {
    std::string name;           ///< at most 1000 bytes
    double youngsModulusPa = 0; ///< Y, 1 to 1e14; for wood along the grain
    double densityKgPerM3 = 0;  ///< ρ, 0.001 to 1e6
    double poissonRatio = 0;    ///< ν, −0.999 to 0.4999
    DampingLaw damping;         ///< γ to 1e6/s, η to 1 s, χ to 10
    double friction = 0;        ///< Coulomb coefficient against itself, 0 to 100
    double restitution = 0;     ///< 0 (dead) to 1 (elastic)
    double roughness = 0;       ///< 0 (polished) to 1 (rough-sawn)
    std::string source;         ///< source of the figures; at most 32 KiB
    /// The ratios of a wood. Only the finite elements use them; all other code treats it as
    /// isotropic.
    std::optional<GrainRatios> grain = {};

    bool operator==(const Material&) const = default;
};

/// Returns the material unchanged, or an error that names the figure or text out of range.
Result<Material> validated(Material material);

/// Returns the materials of Resources/Materials/materials.json, in the order of the parameter. They
/// are read when the program starts. Any thread.
std::span<const Material> materialLibrary();

/// Returns the library material of that name (case-insensitive), or nullptr.
const Material* findMaterial(std::string_view name);

/// Returns the display colour of a library material, 0xRRGGBB.
std::optional<std::uint32_t> materialColour(std::string_view name);

/// Returns the time in which a mode decays by 60 dB: ln(1000)/α. Infinite without damping.
double decaySeconds(const Material& material, double frequencyHz);

} // namespace idiophone
