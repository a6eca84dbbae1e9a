// The memory that the process has allocated, if the C library reports it.
#pragma once

#include <cstdint>
#include <optional>

namespace idiophone {

/// Returns the bytes in use on the main thread's heap, or nothing if this C library does not report
/// them.
std::optional<std::int64_t> heapBytes();

} // namespace idiophone
