// SPDX-License-Identifier: Apache-2.0
#include "Object/FileBytes.h"
#include "Object/MaterialFile.h"
#include "Object/SameName.h"
#include "Object/TextFile.h"

#include <algorithm>
#include <cstdlib>

namespace idiophone {
namespace {

namespace fs = std::filesystem;

#if defined(_WIN32)

fs::path settingsFolder() {
    const wchar_t* value = _wgetenv(L"APPDATA"); // getenv loses characters of some names
    return value != nullptr ? fs::path(value) : fs::path();
}

#else

fs::path fromEnvironment(const char* variable, const char* below = "") {
    const char* value = std::getenv(variable);
    return value != nullptr && *value != '\0' ? fs::path(value) / below : fs::path();
}

fs::path settingsFolder() {
#if defined(__APPLE__)
    return fromEnvironment("HOME", "Library/Application Support");
#else
    const auto configured = fromEnvironment("XDG_CONFIG_HOME");
    return configured.is_absolute() ? configured : fromEnvironment("HOME", ".config");
#endif
}

#endif

std::vector<fs::path> filesOf(const fs::path& folder) {
    std::vector<fs::path> files;
    std::error_code ignored;
    for (fs::directory_iterator entry(folder, ignored), end; entry != end; entry.increment(ignored))
        if (entry->path().extension() == ".json")
            files.push_back(entry->path());
    std::ranges::sort(files); // keeps the order of materials with equal names
    return files;
}

/// Returns the file of a material of this name. Characters that a system forbids become '-'.
fs::path fileOf(const fs::path& folder, std::string name) {
    std::ranges::replace_if(
        name,
        [](unsigned char c) {
            return c < ' ' ||
                   std::string_view("<>:\"/\\|?*").find(char(c)) != std::string_view::npos;
        },
        '-');
    return folder / pathNamed(name + ".json");
}

bool isKnown(std::string_view name, std::span<const Material> materials) {
    return std::ranges::any_of(materials,
                               [&](const Material& known) { return sameName(known.name, name); });
}

} // namespace

UserMaterials readMaterialFolder(const fs::path& folder) {
    UserMaterials found;
    for (const auto& file : filesOf(folder)) {
        auto material = readMaterialFile(file);
        if (material)
            found.materials.push_back(std::move(*material));
        else
            found.faults.push_back(std::move(material.error()));
    }
    std::ranges::stable_sort(found.materials, {}, &Material::name);
    return found;
}

fs::path userMaterialFolder() {
    const auto settings = settingsFolder();
    return settings.empty() ? settings : settings / "Idiophone" / "Materials";
}

Result<Material> addUserMaterial(Material material) {
    const auto folder = userMaterialFolder();
    if (folder.empty())
        return failure("This machine has no folder for materials of your own.");
    std::error_code fault;
    fs::create_directories(folder, fault);
    if (fault)
        return failure(shownNameOf(folder) + ": the folder cannot be made");
    const auto own = readMaterialFolder(folder).materials;
    const auto wanted = material.name;
    auto file = fileOf(folder, wanted);
    for (int number = 2; isKnown(material.name, own) || isKnown(material.name, materialLibrary()) ||
                         fs::exists(file, fault);
         ++number) {
        material.name = wanted + ' ' + std::to_string(number);
        file = fileOf(folder, material.name);
    }
    const auto text = encodeMaterial(material);
    auto read = parseMaterial(text, file);
    if (!read)
        return read;
    if (auto written = writeTextFile(file, text); !written)
        return tl::unexpected(written.error());
    return read;
}

Result<Material> findAnyMaterial(std::string_view name) {
    if (const auto* known = findMaterial(name))
        return *known;
    for (auto& material : readMaterialFolder(userMaterialFolder()).materials)
        if (sameName(material.name, name))
            return std::move(material);
    // An unreadable material only has the name of its file.
    for (const auto& file : filesOf(userMaterialFolder()))
        if (sameName(nameOf(file.stem()), name))
            if (auto material = readMaterialFile(file); !material)
                return material;
    return failure("There is no material '" + std::string(name) +
                   "'; `idiophone materials` lists them.");
}

} // namespace idiophone
