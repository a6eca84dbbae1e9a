// Estimates and exports samples on threads of its own, at most half of the cores, so that the sound
// goes on.
#pragma once

#include "Plugin/RemainingTime.h"
#include "Plugin/SampleOrder.h"

#include <atomic>
#include <condition_variable>
#include <memory>
#include <mutex>
#include <string>
#include <thread>

namespace idiophone {

/// Call every member function from one thread at a time, not the audio thread. The worker runs from
/// the first order to the destructor, and shares the order and the status under `mutex`.
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

    // On the worker.
    void run();
    SampleStatus made(const Job& job);
    SampleStatus estimated(const Job& job, const SampleTask& task);
    SampleStatus exported(const Job& job, const SampleTask& task);
    void report(const Job& job, double progress);

    mutable std::mutex mutex;              ///< for the next five
    std::shared_ptr<Job> waiting, current; ///< `current` is the latest
    SampleStatus shown;
    RemainingTime remaining;
    bool ending = false;
    std::condition_variable wake;
    std::thread worker;
};

} // namespace idiophone
