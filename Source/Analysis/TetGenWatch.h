// The way out of TetGen: its assertions, built so that they throw instead of ending the process,
// and that look up on the way whether it should go on. Internal to Analysis and to TetGen's own
// build.
#pragma once

#include <atomic>
#include <cstdint>

namespace idiophone {

/// Thrown out of TetGen's loops; its workspace is still whole enough to be destroyed.
enum class TetGenStop { assertionFailed, cancelled, tooLong };

struct TetGenWatch {
    const std::atomic<bool>* cancelled = nullptr;
    /// Assertions passed, not time, so that the same input ends the same way.
    std::int64_t checksLeft = 0;

    /// What this thread's calls of TetGen heed.
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
