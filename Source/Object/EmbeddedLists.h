// SPDX-License-Identifier: Apache-2.0
// The lists of Resources inside the program. The build generates their source files
// (cmake/EmbeddedLists.cmake). MaterialLibrary and Mallet parse them.
#pragma once

#include <string_view>

namespace idiophone {

std::string_view embeddedMaterials() noexcept; ///< Resources/Materials/materials.json
std::string_view embeddedMallets() noexcept;   ///< Resources/Mallets/mallets.json

} // namespace idiophone
