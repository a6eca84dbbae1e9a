#include "Console/MaterialChoice.h"

#include "Object/MaterialFile.h"

#include <algorithm>
#include <cctype>

namespace idiophone {
namespace {

bool sameName(const std::string& a, const std::string& b) {
    return std::ranges::equal(
        a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

} // namespace

Result<Material> findOrReadMaterial(const std::string& nameOrFile) {
    if (const auto* known = findMaterial(nameOrFile))
        return *known;
    for (auto& material : readMaterialFolder(userMaterialFolder()).materials)
        if (sameName(material.name, nameOrFile))
            return std::move(material);
    std::error_code ignored;
    if (!std::filesystem::exists(nameOrFile, ignored))
        return failure(nameOrFile + ": it is neither a material's name (`idiophone materials` "
                                    "lists them) nor a file");
    return readMaterialFile(nameOrFile);
}

nlohmann::ordered_json describe(const Material& material) {
    return nlohmann::ordered_json::parse(encodeMaterial(material));
}

} // namespace idiophone
