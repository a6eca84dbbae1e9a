// SPDX-License-Identifier: Apache-2.0
// Threads that share the work of the calling one, for analyses and for rendering to files. In
// WebAssembly a team has no threads (Web/WorkTeam.cpp).
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>
#include <memory>

namespace idiophone {

/// One thread owns it; the other threads only run what it gives them, in its floating-point mode.
/// They wait for the next work without sleeping for about a millisecond, and then sleep. Not for
/// the audio thread.
class WorkTeam {
public:
    /// `threadCount` includes the owner, so that 1 starts no other. 0: one for each core, up to a
    /// maximum.
    explicit WorkTeam(unsigned threadCount, unsigned maximumOfCores = 4);
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

    std::size_t threadCount() const;

    /// Lasts while one thread of a team, or the only thread without one, uses what they share.
    /// Other threads of the team wait for their turns.
    class Turn {
    public:
        explicit Turn(WorkTeam* team); ///< `team` may be null
        ~Turn();
        Turn(const Turn&) = delete;
        Turn& operator=(const Turn&) = delete;

    private:
        [[maybe_unused]] WorkTeam* team; ///< not in WebAssembly
    };

private:
    struct Threads;
    std::unique_ptr<Threads> threads;
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
