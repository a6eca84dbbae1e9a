#include "Analysis/Parallel.h"

#include <algorithm>
#include <atomic>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

namespace idiophone {

unsigned threadsOrAll(unsigned asked) {
    return asked > 0 ? asked : std::max(1U, std::thread::hardware_concurrency());
}

void runOnThreads(std::size_t count,
                  unsigned threads,
                  const std::function<void(std::size_t task, unsigned worker)>& work) {
    std::atomic<std::size_t> next = 0;
    std::mutex faultTurn;
    std::exception_ptr fault;
    const auto run = [&](unsigned worker) {
        try {
            for (std::size_t task = next++; task < count; task = next++)
                work(task, worker);
        } catch (...) {
            const std::scoped_lock turn(faultTurn);
            fault = std::current_exception();
            next = count;
        }
    };
    {
        std::vector<std::jthread> others;
        for (unsigned worker = 1; worker < threads && worker < count; ++worker)
            others.emplace_back(run, worker);
        run(0);
    }
    if (fault)
        std::rethrow_exception(fault);
}

} // namespace idiophone
