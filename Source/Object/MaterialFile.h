// SPDX-License-Identifier: Apache-2.0
// Reads and writes materials on disk: single files and the user's folder.
#pragma once

#include "Object/MaterialText.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

/// Parses one material. `file` names the text in errors. Its stem is the material's name if the
/// text has none.
Result<Material> parseMaterial(std::string_view text, const std::filesystem::path& file);

/// Reads one material from disk.
Result<Material> readMaterialFile(const std::filesystem::path& file);

struct UserMaterials {
    std::vector<Material> materials; ///< sorted by name
    std::vector<Error> faults;       ///< one sentence for each unreadable file
};

/// Reads every *.json of a folder. Returns nothing if the folder does not exist. Message thread.
UserMaterials readMaterialFolder(const std::filesystem::path& folder);

/// Returns the folder of the user's materials: `Idiophone/Materials` in $XDG_CONFIG_HOME (or
/// ~/.config), in ~/Library/Application Support on macOS, in %APPDATA% on Windows. Empty if the
/// environment sets none of these. Creates nothing.
std::filesystem::path userMaterialFolder();

/// Writes the material to a new file in the user's folder, which it makes if needed. If the library
/// or the user has a material of that name, appends a number: "Glass cup 2". Returns the material
/// as it can be read. The error is one sentence: no folder, a name that is too long, or a file that
/// cannot be written. Message thread.
Result<Material> addUserMaterial(Material material);

/// Returns the material of that name (case-insensitive) from the library or the user's folder. The
/// error says that there is none, or what is wrong with a file of that name.
Result<Material> findAnyMaterial(std::string_view name);

} // namespace idiophone
