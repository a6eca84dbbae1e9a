// SPDX-License-Identifier: Apache-2.0
// Threads that share the work of the calling one, for analyses and for rendering to files.
#pragma once

#include <algorithm>
#include <atomic>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <functional>
#include <mutex>
#include <thread>
#include <vector>

namespace idiophone {

/// One thread owns it; the other threads only run what it gives them, in its floating-point mode.
/// They wait for the next work without sleeping for about a millisecond, and then sleep. Not for
/// the audio thread.
class WorkTeam {
public:
    /// `threads` includes the owner, so that 1 starts no other. 0: one for each core, up to a
    /// maximum.
    explicit WorkTeam(unsigned threads, unsigned maximumOfCores = 4);
    ~WorkTeam();
    WorkTeam(const WorkTeam&) = delete;
    WorkTeam& operator=(const WorkTeam&) = delete;

    /// Runs `own` on this thread and `other`, which does not throw, on another one, if one is free.
    /// Returns after both. `own` may call `runAll`.
    void runBoth(const std::function<void()>& other, const std::function<void()>& own);

    /// Handles an item. `thread` is 0 for the owner, and less than `threadCount`. A thread handles
    /// one item at a time.
    using Item = std::function<void(std::size_t item, std::size_t thread)>;

    /// Calls `handle` once for each item below `count` on all free threads, first items first, and
    /// returns after the last. If a call throws, no further ones start, and the owner gets the
    /// exception.
    void runAll(std::size_t count, const Item& handle);

    std::size_t threadCount() const { return others.size() + 1; }

private:
    /// Lasts from a call of `runAll` to the next.
    struct Loop {
        const Item* handle = nullptr;
        std::size_t count = 0;
        std::size_t batch = 1; ///< items that a thread takes at a time
        std::fenv_t mode{};
        std::atomic<std::size_t> next{0};
        std::atomic<bool> isOpen{false};
        std::atomic<int> visitors{0}; ///< other threads that may read the loop
        std::mutex faultTurn;
        std::exception_ptr fault;
    };

    void work(std::size_t thread);
    void wake();
    bool takeTask();
    bool visitLoop(std::size_t thread);
    void runItems(std::size_t thread);

    std::atomic<const std::function<void()>*> task{nullptr}; ///< pending
    std::fenv_t taskMode{};
    std::atomic<bool> isTaskDone{false};
    Loop loop;
    std::atomic<std::uint32_t> wakes{0};
    std::atomic<bool> isStopping{false};
    std::vector<std::thread> others; ///< started last
};

/// Returns 1 without a team.
inline std::size_t threadsOf(const WorkTeam* team) {
    return team != nullptr ? team->threadCount() : 1;
}

/// Calls `handle(item, thread)` as `WorkTeam::runAll` does, or on this thread if there is no team.
template <class Handle>
void shareItems(WorkTeam* team, std::size_t count, const Handle& handle) {
    if (team != nullptr && count > 1)
        return team->runAll(count, handle);
    for (std::size_t item = 0; item < count; ++item)
        handle(item, std::size_t{0});
}

/// Calls `handle(first, count)` for ranges that cover `rows`, one for each thread. Their results
/// must not depend on how the rows are divided.
template <class Handle>
void shareRows(WorkTeam* team, std::ptrdiff_t rows, const Handle& handle) {
    const auto ranges = static_cast<std::ptrdiff_t>(threadsOf(team));
    const std::ptrdiff_t each = ((rows + ranges - 1) / ranges + 7) / 8 * 8;
    shareItems(team, ranges, [&](std::size_t range, std::size_t) {
        if (const auto first = static_cast<std::ptrdiff_t>(range) * each; first < rows)
            handle(first, std::min(each, rows - first));
    });
}

} // namespace idiophone
