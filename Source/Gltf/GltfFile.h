// SPDX-License-Identifier: Apache-2.0
// glTF files on disk, and the files of their buffers.
#pragma once

#include "Gltf/GltfDocument.h"

#include <filesystem>

namespace idiophone {

/// Returns whether the extension of the file's name is .gltf or .glb, in upper or lower case.
bool isGltfFile(const std::filesystem::path& file);

/// Returns a reader of files in the folder and its subfolders. It refuses all other places.
GltfBufferReader buffersIn(const std::filesystem::path& folder);

} // namespace idiophone
