// SPDX-License-Identifier: Apache-2.0
// Objects from files, and from the bytes of every format. The WebAssembly module has Source/Web in
// place of it.
#include "C/Handles.h"
#include "C/ObjectBytes.h"
#include "Gltf/ObjectFile.h"

#include <filesystem>

using namespace idiophone;
using namespace idiophone::c;

Result<ModalObject> idiophone::c::objectOfBytes(std::span<const std::byte> bytes,
                                                std::string_view name) {
    return readObject(bytes, name);
}

idiophone_object* idiophone_object_load(const char* path) {
    return orNull([path]() -> Result<idiophone_object*> {
        if (path == nullptr)
            return failure("no path is given");
        const std::u8string utf8(path, path + std::strlen(path));
        return readObject(std::filesystem::path(utf8)).map(handleOf);
    });
}
