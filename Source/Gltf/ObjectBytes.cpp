// SPDX-License-Identifier: Apache-2.0
#include "Gltf/ObjectBytes.h"

#include "Gltf/GltfObject.h"
#include "Object/ModalObjectBytes.h"
#include "Object/OneLine.h"

#include <string>

namespace idiophone {

Result<ModalObject> readObject(std::span<const std::byte> bytes, std::string_view name) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!text.starts_with("glTF"))
        return readModalObject(bytes, name);
    return firstObjectOf(text).map_error(
        [&](const Error& fault) { return Error{shownName(name) + ": " + fault.message}; });
}

} // namespace idiophone
