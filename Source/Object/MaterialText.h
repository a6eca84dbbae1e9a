// SPDX-License-Identifier: Apache-2.0
// Materials to and from JSON text (docs/materials.md). Material.h explains the figures. Needs no
// file system.
#pragma once

#include "Object/Material.h"

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

/// The largest text that is read as a material or a list of them.
inline constexpr std::size_t largestMaterialBytes = std::size_t{1} << 20;

/// Parses one material. `fileName` stands for the text in errors, which are one sentence.
/// `defaultName` is the material's name if the text has none.
Result<Material>
parseMaterial(std::string_view text, std::string_view fileName, std::string_view defaultName);

/// Parses {"format": "idiophone-materials", "version": 1, "materials": [...]}. Each entry has the
/// members of a material file and a unique name. `fileName` stands for the text in errors.
Result<std::vector<Material>> parseMaterialList(std::string_view text, std::string_view fileName);

/// Returns JSON text from which `parseMaterial` restores an equal material.
std::string encodeMaterial(const Material& material);

} // namespace idiophone
