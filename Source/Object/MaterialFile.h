// Materials as JSON (docs/materials.md): one in a file of its own, the library's in a list, and the
// folder of the user's. What the figures mean is Material's.
#pragma once

#include "Object/Material.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace idiophone {

/// One material; `file` stands for it in errors, which are one sentence, and its stem is the name
/// of a material that says none. A file is at most 1 MiB.
Result<Material> parseMaterial(std::string_view text, const std::filesystem::path& file);

/// The same from disk.
Result<Material> readMaterialFile(const std::filesystem::path& file);

/// {"format": "idiophone-materials", "version": 1, "materials": [...]}: each is what a file of one
/// material holds and has a name of its own. `file` stands for the text in errors.
Result<std::vector<Material>> parseMaterialList(std::string_view text,
                                                const std::filesystem::path& file);

/// The material as JSON text that `parseMaterial` reads back to an equal material.
std::string encodeMaterial(const Material& material);

struct UserMaterials {
    std::vector<Material> materials; ///< by name
    std::vector<Error> faults;       ///< one sentence for each file that could not be read
};

/// Every *.json of a folder; none where there is no such folder. Message thread.
UserMaterials readMaterialFolder(const std::filesystem::path& folder);

/// Where a user's own materials lie: `Idiophone/Materials` in $XDG_CONFIG_HOME (or ~/.config), in
/// ~/Library/Application Support on macOS, in %APPDATA% on Windows. Empty where the environment
/// names none of these. Nothing is created.
std::filesystem::path userMaterialFolder();

/// The material of that name, in any case: the library's, or one of the user's own folder. The
/// error says that there is none, or what is wrong with a file of that name.
Result<Material> findAnyMaterial(std::string_view name);

} // namespace idiophone
