// Estimates and exports samples on threads of its own, at most half of the cores, so that the sound
// goes on.
#pragma once

#include "Plugin/RemainingTime.h"
#include "Plugin/SampleOrder.h"
#include "Plugin/WorkThread.h"

#include <atomic>
#include <memory>
#include <mutex>
#include <string>

namespace idiophone {

/// Call every member function from one thread at a time, not the audio thread. Both sides share the
/// order and the status under `mutex`.
class SampleWorker {
public:
    SampleWorker() = default;
    SampleWorker(const SampleWorker&) = delete;
    SampleWorker& operator=(const SampleWorker&) = delete;
    /// Stops, and waits for a fraction of a second. Leaves no incomplete file.
    ~SampleWorker();

    /// Starts the order. Stops any running one.
    void start(SampleOrder order);
    void stop();
    SampleStatus status() const;

private:
    struct Job {
        SampleOrder order;
        std::atomic<bool> cancelled{false};
    };

    // On the thread.
    void run(const std::shared_ptr<Job>& job);
    SampleStatus made(const Job& job);
    SampleStatus estimated(const Job& job, const SampleTask& task);
    SampleStatus exported(const Job& job, const SampleTask& task);
    void report(const Job& job, double progress);

    mutable std::mutex mutex;     ///< for the next three
    std::shared_ptr<Job> current; ///< the latest
    SampleStatus shown;
    RemainingTime remaining;
    WorkThread thread; ///< last: ends before everything that it uses
};

} // namespace idiophone
