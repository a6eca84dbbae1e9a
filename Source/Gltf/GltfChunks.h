// SPDX-License-Identifier: Apache-2.0
// The parts of a .glb file. Internal to Gltf.
#pragma once

#include <optional>
#include <string_view>

namespace idiophone {

struct GltfChunks {
    std::string_view json;
    std::string_view binary = {}; ///< may end with padding
};

/// Returns the chunks of a .glb file, or the text of a .gltf file. Returns nothing if a .glb file
/// is truncated.
std::optional<GltfChunks> gltfChunksOf(std::string_view bytes);

} // namespace idiophone
