// SPDX-License-Identifier: Apache-2.0
#include "Object/ColourText.h"
#include "Object/EmbeddedLists.h"
#include "Object/Material.h"
#include "Object/MaterialKind.h"
#include "Object/MaterialText.h"
#include "Object/SameName.h"

#include <algorithm>
#include <array>
#include <nlohmann/json.hpp>
#include <stdexcept>
#include <vector>

namespace idiophone {
namespace {

std::vector<Material> parseLibrary() {
    auto materials = parseMaterialList(embeddedMaterials(), "materials.json");
    if (!materials)
        throw std::runtime_error(materials.error().message);
    return std::move(*materials);
}

struct Library {
    std::vector<Material> materials;
    std::vector<std::uint32_t> colours; ///< one for each material
    std::vector<MaterialKind> kinds;    ///< one for each material

    // The list is part of the program and is tested. An error in it ends the program.
    Library() noexcept : materials(parseLibrary()) {
        const auto list = nlohmann::json::parse(embeddedMaterials());
        for (const auto& entry : list.at("materials")) {
            colours.push_back(parseColour(entry.at("colour").get<std::string>()).value());
            kinds.push_back(parseMaterialKind(entry.at("kind").get<std::string>()).value());
        }
    }
};

const Library& library() {
    static const Library onlyOne;
    return onlyOne;
}

// Parse the list at startup, so that the audio thread is never the first to use it.
[[maybe_unused]] const auto& readAtStart = library();

} // namespace

std::span<const Material> materialLibrary() {
    return library().materials;
}

const Material* findMaterial(std::string_view name) {
    const auto all = materialLibrary();
    const auto found = std::ranges::find_if(
        all, [&](const Material& material) { return sameName(material.name, name); });
    return found == all.end() ? nullptr : &*found;
}

std::optional<std::uint32_t> materialColour(std::string_view name) {
    const auto* material = findMaterial(name);
    if (material == nullptr)
        return std::nullopt;
    return library().colours[material - materialLibrary().data()];
}

std::optional<MaterialKind> parseMaterialKind(std::string_view text) {
    constexpr std::array<std::string_view, 6> names{"wood",  "metal",   "glass",
                                                    "stone", "ceramic", "plastic"};
    const auto found = std::ranges::find(names, text);
    if (found == names.end())
        return std::nullopt;
    return static_cast<MaterialKind>(found - names.begin());
}

std::optional<MaterialKind> materialKind(std::string_view name) {
    const auto* material = findMaterial(name);
    if (material == nullptr)
        return std::nullopt;
    return library().kinds[material - materialLibrary().data()];
}

} // namespace idiophone
