#include "Console/BenchHeap.h"

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace idiophone {

std::optional<std::int64_t> heapBytes() {
#ifdef __GLIBC__
    const auto heap = mallinfo2();
    return static_cast<std::int64_t>(heap.uordblks + heap.hblkhd);
#else
    return std::nullopt;
#endif
}

} // namespace idiophone
