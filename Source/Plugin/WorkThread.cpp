#include "Plugin/WorkThread.h"

#include <system_error>
#include <utility>

namespace idiophone {

WorkThread::~WorkThread() {
    {
        const std::scoped_lock lock(mutex);
        ending = true;
    }
    wake.notify_all();
    if (thread.joinable())
        thread.join();
}

void WorkThread::start(Work work) {
    {
        const std::scoped_lock lock(mutex);
        waiting.swap(work); // the former work is destroyed without the mutex
    }
    try {
        if (!thread.joinable())
            thread = std::thread([this] { run(); });
    } catch (const std::system_error&) {
        waiting = nullptr; // without a lock, because no thread runs
        throw;
    }
    wake.notify_all();
}

void WorkThread::run() {
    for (;;) {
        Work work;
        {
            std::unique_lock lock(mutex);
            wake.wait(lock, [this] { return ending || waiting != nullptr; });
            if (ending)
                return;
            work = std::exchange(waiting, nullptr);
        }
        work();
    }
}

} // namespace idiophone
