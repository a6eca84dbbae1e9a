// What the process has allocated, where the C library tells.
#pragma once

#include <cstdint>
#include <optional>

namespace idiophone {

/// Bytes in use on the main thread's heap; nothing where this C library does not say.
std::optional<std::int64_t> heapBytes();

} // namespace idiophone
