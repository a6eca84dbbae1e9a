// The lists of Resources inside the program. The build makes the source files of them
// (cmake/EmbeddedLists.cmake); reading them is MaterialLibrary's and Mallet's.
#pragma once

#include <string_view>

namespace idiophone {

std::string_view embeddedMaterials() noexcept; ///< Resources/Materials/materials.json
std::string_view embeddedMallets() noexcept;   ///< Resources/Mallets/mallets.json

} // namespace idiophone
