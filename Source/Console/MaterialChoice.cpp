#include "Console/MaterialChoice.h"

#include "Object/MaterialFile.h"

namespace idiophone {

Result<Material> findOrReadMaterial(const std::string& nameOrFile) {
    if (auto known = findAnyMaterial(nameOrFile))
        return known;
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
