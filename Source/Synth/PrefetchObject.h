// SPDX-License-Identifier: Apache-2.0
// Fetches a large object into the cache before its use.
#pragma once

#include <cstddef>
#include <hwy/cache_control.h>

namespace idiophone {

/// Fetches all lines of an object at once. Those of a sleeping one are not in the cache, and a
/// strike would wait for most of them one after the other.
template <class Object>
void prefetchObject(const Object& object) noexcept {
    constexpr std::size_t cacheLine = 64;
    const auto* bytes = reinterpret_cast<const std::byte*>(&object);
    for (std::size_t k = 0; k < sizeof(object); k += cacheLine)
        hwy::Prefetch(bytes + k);
}

} // namespace idiophone
