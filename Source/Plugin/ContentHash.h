// Hashes file contents: the same value on every machine and with every standard library.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>

namespace idiophone {

/// FNV-1a; continues from `hash`, the hash of the bytes before.
constexpr std::uint64_t contentHash(std::span<const std::byte> bytes,
                                    std::uint64_t hash = 0xcbf29ce484222325) noexcept {
    for (const auto byte : bytes)
        hash = (hash ^ static_cast<std::uint64_t>(byte)) * 0x100000001b3;
    return hash;
}

} // namespace idiophone
