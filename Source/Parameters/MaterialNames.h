// What the material choice calls the library's materials. The build makes the source file of
// Resources/Materials/materials.json, so that the names stand there alone.
#pragma once

#include <span>
#include <string_view>

namespace idiophone {

/// In the library's order; for the life of the program.
std::span<const std::string_view> libraryMaterialNames() noexcept;

} // namespace idiophone
