// SPDX-License-Identifier: Apache-2.0
#include "Object/MaterialFile.h"

#include "Object/FileBytes.h"
#include "Object/TextFile.h"

namespace idiophone {

Result<Material> parseMaterial(std::string_view text, const std::filesystem::path& file) {
    return parseMaterial(text, nameOf(file), nameOf(file.stem()));
}

Result<Material> readMaterialFile(const std::filesystem::path& file) {
    return readTextFile(file, largestMaterialBytes).and_then([&](const std::string& text) {
        return parseMaterial(text, file);
    });
}

} // namespace idiophone
