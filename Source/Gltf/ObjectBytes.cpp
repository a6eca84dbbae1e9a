// SPDX-License-Identifier: Apache-2.0
#include "Gltf/ObjectBytes.h"

#include "Gltf/GltfObject.h"
#include "Object/ModalObjectBytes.h"
#include "Object/OneLine.h"

#include <new>
#include <string>

namespace idiophone {

Result<ModalObject> readObject(std::span<const std::byte> bytes, std::string_view name) {
    const std::string_view text(reinterpret_cast<const char*>(bytes.data()), bytes.size());
    if (!text.starts_with("glTF"))
        return readModalObject(bytes, name);
    const auto fail = [&](const std::string& fault) {
        return failure(shownName(name) + ": " + fault);
    };
    try {
        auto object = GltfDocument::parse(text).and_then(firstObjectOf);
        if (!object)
            return fail(object.error().message);
        return object;
    } catch (const std::bad_alloc&) {
        return fail("it is too large for this machine's memory");
    }
}

} // namespace idiophone
