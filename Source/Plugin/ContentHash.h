// Names for contents: the same on every machine and of every standard library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

/// FNV-1a; goes on from the hash of what comes before.
constexpr std::uint64_t contentHash(std::span<const std::byte> bytes,
                                    std::uint64_t hash = 0xcbf29ce484222325) noexcept {
    for (const auto byte : bytes)
        hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
    return hash;
}

} // namespace idiophone
