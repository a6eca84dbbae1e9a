// SPDX-License-Identifier: Apache-2.0
#include "Gltf/GltfChunks.h"

#include <cstddef>

namespace idiophone {
namespace {

std::size_t littleEndianCount(std::string_view bytes) {
    std::size_t count = 0;
    for (std::size_t i = 4; i-- > 0;)
        count = count << 8 | static_cast<unsigned char>(bytes[i]);
    return count;
}

/// Takes the next chunk from the rest of a .glb file. Returns nothing if it is not whole.
std::optional<std::string_view> takeChunk(std::string_view& rest) {
    constexpr std::size_t headerBytes = 8; // length and type
    if (rest.size() < headerBytes)
        return std::nullopt;
    const auto size = littleEndianCount(rest);
    if (size > rest.size() - headerBytes)
        return std::nullopt;
    const auto chunk = rest.substr(headerBytes, size);
    rest.remove_prefix(headerBytes + size);
    return chunk;
}

} // namespace

std::optional<GltfChunks> gltfChunksOf(std::string_view bytes) {
    constexpr std::size_t headerBytes = 12; // magic, version, length of the file
    if (!bytes.starts_with("glTF"))
        return GltfChunks{.json = bytes};
    if (bytes.size() < headerBytes || littleEndianCount(bytes.substr(8)) > bytes.size())
        return std::nullopt;
    auto rest = bytes.substr(headerBytes);
    const auto json = takeChunk(rest);
    if (!json)
        return std::nullopt;
    const bool hasBinary = rest.substr(0, 8).ends_with(std::string_view("BIN\0", 4));
    const auto binary = hasBinary ? takeChunk(rest) : std::string_view{};
    if (!binary)
        return std::nullopt;
    return GltfChunks{.json = *json, .binary = *binary};
}

} // namespace idiophone
