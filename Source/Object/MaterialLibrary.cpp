#include "Object/EmbeddedLists.h"
#include "Object/Material.h"
#include "Object/MaterialFile.h"
#include "Object/SameName.h"

#include <algorithm>
#include <cstdlib>
#include <vector>

namespace idiophone {
namespace {

std::vector<Material> parseLibrary() {
    auto materials = parseMaterialList(embeddedMaterials(), "materials.json");
    // Part of the program, and the tests read every one of them.
    if (!materials)
        std::abort();
    return std::move(*materials);
}

const std::vector<Material>& library() {
    static const auto materials = parseLibrary();
    return materials;
}

// Read before anything runs: the audio thread must not be the first to ask.
[[maybe_unused]] const auto& readAtStart = library();

} // namespace

std::span<const Material> materialLibrary() {
    return library();
}

const Material* findMaterial(std::string_view name) {
    const auto found = std::ranges::find_if(
        library(), [&](const Material& material) { return sameName(material.name, name); });
    return found == library().end() ? nullptr : &*found;
}

} // namespace idiophone
