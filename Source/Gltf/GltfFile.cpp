// SPDX-License-Identifier: Apache-2.0
#include "Gltf/GltfFile.h"

#include "Object/FileBytes.h"
#include "Object/SameName.h"

#include <algorithm>

namespace idiophone {

bool isGltfFile(const std::filesystem::path& file) {
    const auto extension = nameOf(file.extension());
    return sameName(extension, ".gltf") || sameName(extension, ".glb");
}

GltfBufferReader buffersIn(const std::filesystem::path& folder) {
    return [folder](const std::string& name, std::uintmax_t limitBytes) -> Result<std::string> {
        const auto path = pathNamed(name);
        if (path.empty() || path.has_root_path() || isNetworkName(name) ||
            std::ranges::find(path, std::filesystem::path("..")) != path.end())
            return failure("it is not in the folder of the file");
        return readBytes(folder / path, limitBytes);
    };
}

} // namespace idiophone
