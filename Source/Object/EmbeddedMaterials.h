// Resources/Materials/materials.json inside the program. The build makes the source file of it;
// reading it is MaterialLibrary's.
#pragma once

#include <string_view>

namespace idiophone {

std::string_view embeddedMaterials() noexcept;

} // namespace idiophone
