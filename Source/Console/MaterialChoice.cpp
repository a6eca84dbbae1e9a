#include "Console/MaterialChoice.h"

#include "Object/MaterialFile.h"

namespace idiophone {

Result<Material> findOrReadMaterial(const std::string& nameOrFile) {
    auto known = findAnyMaterial(nameOrFile);
    std::error_code ignored;
    if (known || !std::filesystem::exists(nameOrFile, ignored))
        return known;
    return readMaterialFile(nameOrFile);
}

nlohmann::ordered_json describe(const Material& material) {
    return nlohmann::ordered_json::parse(encodeMaterial(material));
}

} // namespace idiophone
