// Watches code that must not allocate, lock or call the system: counts what it does of that while
// it runs. And leaves code without memory or threads. Linux with glibc; not under the sanitizers,
// which replace the same functions.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace idiophone::test {

struct RealTimeFaults {
    int allocations = 0; ///< malloc, free and their kin, and so new and delete
    int locks = 0;       ///< any call that may wait for another thread or wake one, of pthread and
                         ///< semaphores, and the first use of a function's static variable
    int systemCalls = 0;
    std::string first; ///< names the first fault

    bool none() const { return allocations + locks + systemCalls == 0; }
};

/// Whether faults are seen at all here, and whether system calls are.
bool realTimeTrapWorks();
bool systemCallTrapWorks();

/// [any one thread] Between the two, the calling thread is watched.
void beginRealTimeWatch();
RealTimeFaults endRealTimeWatch();

template <class Callback>
RealTimeFaults faultsOf(Callback&& callback) {
    beginRealTimeWatch();
    callback();
    return endRealTimeWatch();
}

/// While it lives, this thread gets no memory of more bytes in one piece: `new` throws. Where
/// `realTimeTrapWorks`.
class MemoryLimit {
public:
    explicit MemoryLimit(std::size_t mostBytes);
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;
    ~MemoryLimit();
};

/// While it lives, this thread can start no other. Where `realTimeTrapWorks`.
class NoThreads {
public:
    NoThreads();
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;
    ~NoThreads();
};

/// While it lives, this thread calls `each` at every allocation and release, but for those of
/// `each`: what another thread may do meanwhile, at many moments and always the same ones. Where
/// `realTimeTrapWorks`.
class AtAllocations {
public:
    explicit AtAllocations(std::function<void()> each);
    AtAllocations(const AtAllocations&) = delete;
    AtAllocations& operator=(const AtAllocations&) = delete;
    ~AtAllocations();

private:
    std::function<void()> called;
};

} // namespace idiophone::test
