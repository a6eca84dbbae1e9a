// Finds the material that an option names: in the library, in the user's folder, or in a file.
#pragma once

#include "Object/Material.h"

#include <nlohmann/json.hpp>
#include <string>

namespace idiophone {

/// Returns the library's material of that name, or else the user's (Object/MaterialFile.h), or else
/// the one in the JSON file of that path.
Result<Material> findOrReadMaterial(const std::string& nameOrFile);

/// Returns the material as JSON that can be read back.
nlohmann::ordered_json describe(const Material& material);

} // namespace idiophone
