// Threads that share the work of the calling one, for rendering to files.
#pragma once

#include <atomic>
#include <cfenv>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <thread>
#include <vector>

namespace idiophone {

/// One thread owns it; the other threads only run what it gives them, in its floating-point mode.
/// They wait for the next work without sleeping for about a millisecond, and then sleep. Work does
/// not throw, except `own` of `runBoth`. Not for the audio thread.
class WorkTeam {
public:
    /// `threads` includes the owner, so that 1 starts no other. 0: one for each core, at
    /// most four.
    explicit WorkTeam(unsigned threads);
    ~WorkTeam();
    WorkTeam(const WorkTeam&) = delete;
    WorkTeam& operator=(const WorkTeam&) = delete;

    /// Runs `own` on this thread and `other` on another one, if one is free, and returns after
    /// both. `own` may call `runAll`.
    void runBoth(const std::function<void()>& other, const std::function<void()>& own);

    /// Handles an item. `thread` is 0 for the owner, and less than `threadCount`.
    using Item = std::function<void(std::size_t item, std::size_t thread)>;

    /// Calls `handle` once for each item below `count` on all free threads, first items first, and
    /// returns after the last.
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

} // namespace idiophone
