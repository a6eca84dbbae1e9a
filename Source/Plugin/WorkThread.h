// A thread for long work of the window, one piece at a time.
#pragma once

#include <condition_variable>
#include <functional>
#include <mutex>
#include <thread>

namespace idiophone {

/// Call it from one thread at a time. The thread runs from the first piece of work to the
/// destructor, which waits for the running piece: cancel it before.
class WorkThread {
public:
    using Work = std::function<void()>;

    WorkThread() = default;
    WorkThread(const WorkThread&) = delete;
    WorkThread& operator=(const WorkThread&) = delete;
    ~WorkThread();

    /// Runs the work after the running piece. It replaces work that still waits, and must not
    /// throw. Throws std::system_error, and drops the work, if this machine starts no more threads.
    void start(Work work);

private:
    void run();

    std::mutex mutex;
    std::condition_variable wake;
    Work waiting;
    bool ending = false;
    std::thread thread;
};

} // namespace idiophone
