// Runs independent tasks on the machine's cores. Internal to Analysis.
#pragma once

#include <algorithm>
#include <cstddef>
#include <functional>

namespace idiophone {

/// Returns `asked`, or the number of the machine's cores if that is 0.
unsigned threadsOrAll(unsigned asked);

/// Internal to inParallel.
void runOnThreads(std::size_t count,
                  unsigned threads,
                  const std::function<void(std::size_t task, unsigned worker)>& work);

/// Calls `work(task, worker)` once for each task below `count`, on up to `threads` threads, and
/// returns when all are done. Tasks start in ascending order. The caller is worker 0. A worker
/// runs one task at a time. If a task throws, no further ones start, and the caller gets the
/// exception.
template <class Work>
void inParallel(std::size_t count, unsigned threads, const Work& work) {
    if (threads > 1 && count > 1)
        return runOnThreads(count, threads, work);
    for (std::size_t task = 0; task < count; ++task)
        work(task, 0U);
}

/// Calls `work(first, count)` for ranges that cover `rows`, one for each thread. Their results must
/// not depend on how the rows are divided.
template <class Work>
void divideRows(std::ptrdiff_t rows, unsigned threads, const Work& work) {
    const std::ptrdiff_t each = ((rows + threads - 1) / threads + 7) / 8 * 8;
    inParallel(threads, threads, [&](std::size_t range, unsigned) {
        if (const auto first = static_cast<std::ptrdiff_t>(range) * each; first < rows)
            work(first, std::min(each, rows - first));
    });
}

} // namespace idiophone
