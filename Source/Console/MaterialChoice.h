// Which material an option names: one of the library's, one of the user's, or a file.
#pragma once

#include "Object/Material.h"

#include <nlohmann/json.hpp>
#include <string>

namespace idiophone {

/// The library's material of that name, or else the user's (Object/MaterialFile.h), or else the one
/// in the JSON file of that path.
Result<Material> findOrReadMaterial(const std::string& nameOrFile);

/// The material as JSON that can be read back.
nlohmann::ordered_json describe(const Material& material);

} // namespace idiophone
