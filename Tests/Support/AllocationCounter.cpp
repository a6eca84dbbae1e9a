#include "Support/AllocationCounter.h"

#include <atomic>
#include <cstdlib>
#include <new>

namespace {
std::atomic<long> handedOut{0};
}

void* operator new(std::size_t size) {
    ++handedOut;
    if (void* memory = std::malloc(size > 0 ? size : 1))
        return memory;
    throw std::bad_alloc();
}
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
    ++handedOut;
    return std::malloc(size > 0 ? size : 1);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}

namespace idiophone::test {

AllocationCounter::AllocationCounter() : before(handedOut.load()) {}

long AllocationCounter::allocations() const {
    return handedOut.load() - before;
}

} // namespace idiophone::test
