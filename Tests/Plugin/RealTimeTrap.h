// Counts allocations, locks and system calls of the code under test. Can also deny that code
// memory or threads. Works on Linux with glibc, but not under the sanitizers, which replace the
// same functions.
#pragma once

#include <cstddef>
#include <functional>
#include <string>

namespace idiophone::test {

struct RealTimeFaults {
    int allocations = 0; ///< malloc, free, new, delete and their variants
    /// Calls of pthread or semaphores that may wait for a thread or wake one, and the first use of
    /// a function's static variable.
    int locks = 0;
    int systemCalls = 0;
    int wakes = 0;     ///< futex calls that wake a thread and do not wait: no faults on a stage
    std::string first; ///< names the first fault

    bool none() const { return allocations + locks + systemCalls == 0; }
};

/// Returns whether faults can be counted here, and whether system calls can.
bool realTimeTrapWorks();
bool systemCallTrapWorks();

/// [any one thread] Watches the calling thread between the two calls.
void beginRealTimeWatch();
RealTimeFaults endRealTimeWatch();

template <class Callback>
RealTimeFaults faultsOf(Callback&& callback) {
    beginRealTimeWatch();
    callback();
    return endRealTimeWatch();
}

/// While it lives, `new` throws on this thread for more than `maximumBytes` in one piece. Needs
/// `realTimeTrapWorks`.
class MemoryLimit {
public:
    explicit MemoryLimit(std::size_t maximumBytes);
    MemoryLimit(const MemoryLimit&) = delete;
    MemoryLimit& operator=(const MemoryLimit&) = delete;
    ~MemoryLimit();
};

/// While this object lives, this thread cannot start another. Needs `realTimeTrapWorks`.
class NoThreads {
public:
    NoThreads();
    NoThreads(const NoThreads&) = delete;
    NoThreads& operator=(const NoThreads&) = delete;
    ~NoThreads();
};

/// While this object lives, calls `each` at every allocation and release of this thread, except
/// those of `each` itself. It stands for another thread that acts at many reproducible moments.
/// Needs `realTimeTrapWorks`.
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
