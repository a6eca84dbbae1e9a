// SPDX-License-Identifier: Apache-2.0
// Objects from files, which the WebAssembly module leaves out.
#include "C/Handles.h"
#include "Gltf/ObjectFile.h"

#include <filesystem>

using namespace idiophone;
using namespace idiophone::c;

idiophone_object* idiophone_object_load(const char* path) {
    return orNull([path]() -> Result<idiophone_object*> {
        if (path == nullptr)
            return failure("no path is given");
        const std::u8string utf8(path, path + std::strlen(path));
        return readObject(std::filesystem::path(utf8)).map(handleOf);
    });
}
