// Stops TetGen. Its assertions are built to throw instead of ending the process. They also check
// for cancellation. Internal to Analysis and to TetGen's own build.
#pragma once

#include <atomic>
#include <cstdint>

namespace idiophone {

/// Thrown out of TetGen's loops. Its workspace can still be destroyed.
enum class TetGenStop { assertionFailed, cancelled, tooLong };

struct TetGenWatch {
    const std::atomic<bool>* cancelled = nullptr;
    /// Counts assertions, not time, so that the same input gives the same result.
    std::int64_t checksLeft = 0;

    /// The settings for TetGen calls on this thread.
    static TetGenWatch& current() {
        static thread_local TetGenWatch watch;
        return watch;
    }
};

inline void checkInTetGen(bool holds) {
    if (!holds)
        throw TetGenStop::assertionFailed;
    auto& watch = TetGenWatch::current();
    if (--watch.checksLeft < 0)
        throw TetGenStop::tooLong;
    if (watch.checksLeft % 4096 == 0 && watch.cancelled != nullptr && watch.cancelled->load())
        throw TetGenStop::cancelled;
}

} // namespace idiophone
