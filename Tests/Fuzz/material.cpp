// Fuzzes user materials and lists of materials.
#include "Fuzz/FuzzTarget.h"
#include "Object/MaterialFile.h"

namespace idiophone::fuzz {
namespace {

void claimSound(const Material& material) {
    claim(validated(material).has_value(), "figures are in range");
    claim(!material.name.empty(), "a material has a name");
    const auto again = parseMaterial(encodeMaterial(material), "again.json");
    claim(again && *again == material, "a material that was written reads back equal");
}

} // namespace

void examine(std::string_view bytes) {
    if (const auto material = parseMaterial(bytes, "fuzz.json"))
        claimSound(*material);
    else
        claimSentence(material.error());
    if (const auto list = parseMaterialList(bytes, "fuzz.json"))
        std::ranges::for_each(*list, claimSound);
    else
        claimSentence(list.error());
}

} // namespace idiophone::fuzz
