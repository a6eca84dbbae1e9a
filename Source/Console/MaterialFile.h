// Materials by name or from a JSON file, as the console's options and lists have them.
#pragma once

#include "Object/Material.h"

#include <nlohmann/json.hpp>
#include <string>

namespace idiophone {

/// The library's material of that name, or else the one in the JSON file of that path: an object
/// with `youngs_modulus_pa`, `density_kg_per_m3`, `poisson_ratio`, `fluid_damping_per_s` and
/// `viscoelastic_damping_s`, and at will the other members that `describe` writes.
Result<Material> findOrReadMaterial(const std::string& nameOrFile);

/// The material as JSON that can be read back.
nlohmann::ordered_json describe(const Material& material);

} // namespace idiophone
